using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Stress.Reference;

/// <summary>
/// What a pixel shows of the reference sphere, by the thesis's steps (section 9.3) to some 30 digits: the quadratic of eq. 8.4, a second
/// point 1000 m towards the Sun, the images of both. Nothing of the program's own formulas.
/// </summary>
public sealed class PrecisePixel
{
    private readonly PreciseCamera _camera;
    private readonly int _x;
    private readonly int _y;
    private readonly PreciseVector _direction;

    private PrecisePixel(PreciseCamera camera, int x, int y, PreciseVector direction, PreciseVector point)
    {
        _camera = camera;
        _x = x;
        _y = y;
        _direction = direction;
        Point = point;
    }

    /// <summary>m, MOON_ME.</summary>
    public PreciseVector Point { get; }

    /// <summary>Cosine of the angle between the line of sight and the zenith.</summary>
    public double CosEmission => -(PreciseVector.Dot(_direction, Point) / (_direction.Length * Point.Length)).High;

    /// <summary>The pixel's point, or null for space.</summary>
    public static PrecisePixel? At(PreciseCamera camera, int x, int y)
    {
        PreciseVector direction = camera.DirectionThrough(x, y);
        DoubleWord square = PreciseVector.Dot(direction, direction);
        DoubleWord approach = -PreciseVector.Dot(camera.Position, direction) / square;

        // The quadratic for an origin moved to the nearest approach: the square of 1e12 m would leave 1e-8 m2 of the half chord's.
        PreciseVector nearest = camera.Position + (approach * direction);
        DoubleWord half = PreciseVector.Dot(nearest, direction);
        DoubleWord discriminant = (half * half) - (square * Power(nearest));
        if (approach.High <= 0.0 || Power(camera.Position).High < 0.0 || discriminant.High < 0.0)
        {
            return null;
        }

        DoubleWord parameter = (-half - DoubleWord.Sqrt(discriminant)) / square;
        return new PrecisePixel(camera, x, y, direction, nearest + (parameter * direction));
    }

    /// <summary>m: how far from the sphere a pixel's ray passes.</summary>
    public static double FromTangent(PreciseCamera camera, int x, int y)
    {
        PreciseVector direction = camera.DirectionThrough(x, y);
        DoubleWord nearest = PreciseVector.Cross(camera.Position, direction).Length / direction.Length;
        return Math.Abs((nearest - MoonConstants.ReferenceRadius).High);
    }

    /// <summary>
    /// Sine of the Sun's zenith angle times the sine between ground line and line of sight, as much as the image shows of it: by it the
    /// illumination direction is known.
    /// </summary>
    public double DirectionSine(Vector3D sun)
    {
        PreciseVector normal = 1.0 / _direction.Length * PreciseVector.Cross(_direction, GroundLine(sun));
        return PreciseVector.Cross(normal, _camera.Forward).Length.High;
    }

    /// <summary>The illumination direction as a vector: its angle counts from down, (1, 0), to the right, (0, 1).</summary>
    public (DoubleWord Down, DoubleWord Right) IlluminationDirection(Vector3D sun)
    {
        PreciseVector groundLine = GroundLine(sun);
        double step = 1000.0;
        while (!_camera.IsInFront(Point + (step * groundLine)))
        {
            step /= 2.0; // the second point lies behind the camera: a nearer one on the same line does not
        }

        (DoubleWord right, DoubleWord down) = _camera.PlaceFrom(_x, _y, Point + (step * groundLine));
        return (down, right);
    }

    /// <summary>Of a point with regard to the sphere: squared distance from its centre less its squared radius.</summary>
    private static DoubleWord Power(PreciseVector point) =>
        PreciseVector.Dot(point, point) - ((DoubleWord)MoonConstants.ReferenceRadius * MoonConstants.ReferenceRadius);

    /// <summary>Along the ground towards the Sun; its length is the sine of the Sun's zenith angle.</summary>
    private PreciseVector GroundLine(Vector3D sun)
    {
        PreciseVector zenith = Point.Normalized();
        PreciseVector toSun = (PreciseVector.From(sun) - Point).Normalized();
        return toSun - (PreciseVector.Dot(toSun, zenith) * zenith);
    }
}
