using Msisf.Core.Camera.Lenses;

namespace Msisf.Core.Camera;

/// <summary>
/// A camera in the form of OpenCV: a point p (m, MOON_ME) lies at R p + t in camera axes, x right, y down, z forward, and is seen at
/// u = f x / z + cx, v = f y / z + cy. Pixel centres are whole numbers from 0, so u = 0 is the meta file's h = 1. Immutable.
/// </summary>
/// <param name="Width">Image width, px.</param>
/// <param name="Height">Image height, px.</param>
/// <param name="FocalLength">f, px, along rows.</param>
/// <param name="PrincipalX">cx, px: where the optical axis meets the image.</param>
/// <param name="PrincipalY">cy, px.</param>
/// <param name="Rotation">R: turns MOON_ME vectors into camera axes.</param>
/// <param name="Translation">t, m: the Moon's centre in camera axes, -R times the camera's position.</param>
public sealed record CameraMatrix(
    int Width, int Height, double FocalLength, double PrincipalX, double PrincipalY, RotationMatrix Rotation, Vector3D Translation)
{
    /// <summary>f along columns, px; equal to the one along rows where pixels are square.</summary>
    public double FocalLengthDown { get; init; } = FocalLength;

    /// <summary>px: the element of K's first row and second column.</summary>
    public double Skew { get; init; }

    /// <summary>The distortion of the lens, applied before K; null for a pinhole.</summary>
    public Distortion? Distortion { get; init; }

    /// <summary>The three rows of K.</summary>
    public IReadOnlyList<Vector3D> IntrinsicRows =>
        [new(FocalLength, Skew, PrincipalX), new(0.0, FocalLengthDown, PrincipalY), Vector3D.UnitZ];

    /// <summary>The three rows of R.</summary>
    public IReadOnlyList<Vector3D> RotationRows => [Rotation.Row0, Rotation.Row1, Rotation.Row2];

    /// <summary>The same camera in OpenCV's form; of one with several states that of its first row.</summary>
    public static CameraMatrix Of(ICamera camera)
    {
        FrameCamera first = camera.Bands[0].Camera;
        RotationMatrix rotation = new(first.UnitRight, first.MoonFromCamera * -Vector3D.UnitZ, first.ForwardBodyFixed);
        Vector3D translation = default(Vector3D) - (rotation * first.PositionBodyFixed); // no negative zeros
        CameraModel model = first.Model;
        return new CameraMatrix(
            camera.Width, camera.Height, model.FocalX, model.PrincipalX - 1.0, model.PrincipalY - 1.0, rotation, translation)
        {
            FocalLengthDown = model.FocalY,
            Skew = model.Skew,
            Distortion = model.Distortion,
        };
    }
}
