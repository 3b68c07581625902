using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Render.Sampling;

/// <summary>A frame whose pixels get several samples, and what it is drawn with.</summary>
/// <param name="Frame">Knows the blocks of terrain that the frame may show.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="Lights">Finds light and brightness.</param>
/// <param name="Options">The settings.</param>
/// <param name="RadianceFactors">The brightness of the pixels.</param>
/// <param name="Threads">Maximum number of threads; the result does not depend on it.</param>
/// <param name="Cancellation">Cancels the work.</param>
internal sealed record SampledFrame(
    VisibilityPass Frame, SceneLight Light, LightPass Lights, NativeRenderOptions Options, double[] RadianceFactors, int Threads,
    CancellationToken Cancellation);
