using Msisf.App.Settings;

namespace Msisf.App.Serving;

/// <summary>A frame that a client asks for; its options are checked.</summary>
/// <param name="Model">The elevation model.</param>
/// <param name="Place">Where the camera is; null if the request need not say it and does not.</param>
/// <param name="Settings">The other options.</param>
internal sealed record RequestedFrame(ServedModel Model, CameraSettings? Place, RenderSettings Settings);
