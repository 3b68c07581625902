using Msisf.Core.Camera;

namespace Msisf.Core.Detector;

/// <summary>Points of light beside the ground, such as stars, whose light a detector collects. Safe for several threads.</summary>
public interface IPointLights
{
    /// <summary>Adds the electrons of one exposure.</summary>
    /// <param name="image">Gets them in the exposure's rows.</param>
    void Collect(PointExposure exposure, CameraDetector detector, DetectorImage image, CancellationToken cancellation);
}

/// <summary>A time in which some rows of an image are exposed.</summary>
/// <param name="Rows">The rows, from 0; the first row of the cameras is the first of them.</param>
/// <param name="CameraAt">The camera of these rows some seconds after the image's time.</param>
/// <param name="Middle">s after the image's time.</param>
/// <param name="Span">s: how long the camera moves while they are exposed; 0 for an image without its motion.</param>
public sealed record PointExposure(PixelRows Rows, Func<double, FrameCamera> CameraAt, double Middle, double Span)
{
    /// <summary>rad/s: how fast the camera turns over the body at most.</summary>
    public double AngularSpeed { get; init; }

    /// <summary>m/s, body-fixed: how the camera flies from the begin of the exposure to its end.</summary>
    public Vector3D Velocity => Span == 0.0
        ? default
        : (CameraAt(Middle + (0.5 * Span)).PositionBodyFixed - CameraAt(Middle - (0.5 * Span)).PositionBodyFixed) / Span;
}
