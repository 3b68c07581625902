using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.Core.Navigation;

/// <summary>The other frame of a flow.</summary>
/// <param name="Camera">Its camera.</param>
/// <param name="Light">Its light.</param>
public sealed record FlowTarget(FrameCamera Camera, SceneLight Light);
