using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Navigation;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>One image to render.</summary>
/// <param name="Step">Number of the frame, from 1, in the order of the input.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Time">Time, UTC.</param>
/// <param name="Camera">Camera of the image.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="Motion">How the camera moves during the exposure; null for images without it.</param>
/// <param name="Noise">The noise of the camera's detector; null for that of the detector's seed and the frame's state.</param>
internal sealed record Frame(
    int Step, string Name, ModifiedJulianDate Time, ICamera Camera, SceneLight Light, CameraMotion? Motion = null,
    NoiseSeed? Noise = null)
{
    /// <summary>The frame to which its flow leads; null without a flow.</summary>
    public FlowTarget? Flow { get; init; }

    /// <summary>The camera for POV-Ray.</summary>
    /// <exception cref="BadInputException">Its rows have several states.</exception>
    public FrameCamera FrameCamera => Camera as FrameCamera ?? throw new BadInputException(
        "the rows of this camera have times and places of their own, which POV-Ray can't draw. Use --renderer native.");
}
