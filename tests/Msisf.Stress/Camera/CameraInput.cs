using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>A camera and one of its pixels: the inputs of a case.</summary>
/// <param name="Position">m, MOON_ME.</param>
/// <param name="MoonFromCamera">Attitude.</param>
/// <param name="FieldOfView">rad.</param>
/// <param name="Frame">The image and the pixel.</param>
public sealed record CameraInput(Vector3D Position, UnitQuaternion MoonFromCamera, double FieldOfView, PixelFrame Frame)
{
    /// <summary>The program's camera.</summary>
    public PinholeCamera ToCamera() => new(Position, MoonFromCamera, FieldOfView, Frame.Width, Frame.Height);

    /// <summary>The reference's.</summary>
    public PreciseCamera ToPrecise() =>
        new(Position, (MoonFromCamera.X, MoonFromCamera.Y, MoonFromCamera.Z, MoonFromCamera.W), FieldOfView, Frame.Width, Frame.Height);

    /// <summary>Complete, in round-trip numbers.</summary>
    public override string ToString() => string.Create(
        CultureInfo.InvariantCulture,
        $"camera {Position} {MoonFromCamera} FOV {FieldOfView:R} rad {Frame.Width} x {Frame.Height} px, pixel ({Frame.X}, {Frame.Y})");
}
