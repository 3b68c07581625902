using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Stress.Camera;

/// <summary>Draws cameras of all kinds, turned so that a pixel of theirs, not the middle, looks where it is told to.</summary>
/// <param name="random">Draws.</param>
internal sealed class AimedCameras(CaseRandom random)
{
    /// <summary>px: the longest side of an image.</summary>
    private const int LongestSide = 16384;

    /// <summary>Longest to shortest side of an image, at most.</summary>
    private const int MaxAspect = 1000;

    private const double MinFovDegrees = 1e-4;
    private const double MaxFovDegrees = 179.9;

    /// <summary>Kinds of place that <see cref="Zenith"/> goes through.</summary>
    private const int Kinds = 6;

    /// <summary>Where a camera stands: on the polar axis exactly, near it, on a tile's corner, or anywhere.</summary>
    public Vector3D Zenith(int number) => (number % Kinds) switch
    {
        0 => new Vector3D(0.0, 0.0, random.Sign()),
        1 => new Vector3D(random.Logarithmic(1e-17, 1e-2), random.Logarithmic(1e-17, 1e-2), random.Sign()).Normalized(),
        2 => TileCorner(),
        _ => random.Direction(),
    };

    /// <summary>A camera over a place whose pixel's ray passes the Moon's centre at a distance.</summary>
    /// <param name="position">m, MOON_ME, not the centre.</param>
    /// <param name="nearest">m, at most the camera's own distance.</param>
    public CameraInput Passing(Vector3D position, double nearest)
    {
        double distance = position.Length;
        Vector3D zenith = position / distance;
        Vector3D sideward = Vector3D.Cross(zenith, random.Direction()).Normalized();
        double sine = nearest / distance;
        double cosine = Math.Sqrt(Math.Max(0.0, (distance - nearest) * (distance + nearest))) / distance;
        return Towards(position, (sine * sideward) - (cosine * zenith));
    }

    /// <summary>A camera whose pixel looks along a direction, the image turned at random about it.</summary>
    public CameraInput Towards(Vector3D position, Vector3D direction)
    {
        double fov = double.DegreesToRadians(
            random.Below(2) == 0 ? random.Logarithmic(MinFovDegrees, MaxFovDegrees) : random.Between(1.0, MaxFovDegrees));
        int width = (int)random.Logarithmic(1.0, LongestSide + 1);
        int height = (int)random.Logarithmic(
            Math.Max(1.0, (double)width / MaxAspect), Math.Min(LongestSide, (double)width * MaxAspect) + 1.0);
        PixelFrame frame = new(width, height, random.Below(width) + 1, random.Below(height) + 1);
        return new CameraInput(position, Aimed(frame, fov, direction), fov, frame);
    }

    private static (Vector3D First, Vector3D Second) Across(Vector3D axis, Vector3D other)
    {
        Vector3D first = Vector3D.Cross(axis, other).Normalized();
        return (first, Vector3D.Cross(axis, first));
    }

    private Vector3D TileCorner()
    {
        double latitude = double.DegreesToRadians(TileId.SizeDegrees * (random.Below(TileId.Rows + 1) - (TileId.Rows / 2)));
        double longitude = double.DegreesToRadians(TileId.SizeDegrees * random.Below(TileId.Columns));
        return new SelenographicPoint(latitude, longitude).ToDirectionBodyFixed();
    }

    private UnitQuaternion Aimed(PixelFrame frame, double fov, Vector3D direction)
    {
        double aspect = (double)frame.Width / frame.Height;
        Vector3D inCamera = new Vector3D(
            -aspect / 2.0 / Math.Tan(fov / 2.0),
            aspect * ((2.0 * frame.X) - 1.0 - frame.Width) / (2.0 * frame.Width),
            (1.0 + frame.Height - (2.0 * frame.Y)) / (2.0 * frame.Height)).Normalized();
        Vector3D inMoon = direction.Normalized();
        (Vector3D u, Vector3D v) = Across(inCamera, random.Direction());
        (Vector3D p, Vector3D q) = Across(inMoon, random.Direction());

        // The matrix that turns (inCamera, u, v) into (inMoon, p, q).
        Vector3D Row(double a, double b, double c) => (a * inCamera) + (b * u) + (c * v);
        return UnitQuaternion.FromMatrix(new RotationMatrix(
            Row(inMoon.X, p.X, q.X), Row(inMoon.Y, p.Y, q.Y), Row(inMoon.Z, p.Z, q.Z)));
    }
}
