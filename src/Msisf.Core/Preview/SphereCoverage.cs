using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.Core.Preview;

/// <summary>
/// Measures how much of an image shows a sphere, and how much of that is lit. The image is cut into rows between the highest and the lowest
/// point of the sphere in it. In each row the sphere is seen on one interval, whose ends are exact; the light is sampled on a grid over
/// these intervals, at their ends too, so that a sphere of less than a pixel and a thin crescent are found.
/// </summary>
/// <remarks>
/// Image plane coordinates are tangents: a ray is forward + a right + b up. Rows and samples lie closer at both ends (sines of equal
/// steps), where the limb turns fastest.
/// </remarks>
internal sealed class SphereCoverage
{
    private const int Rows = 32;
    private const int Steps = 32;

    private static readonly double[] RowEdges = Sines(Rows, 0.0);
    private static readonly double[] RowMiddles = Sines(Rows, 0.5);
    private static readonly double[] StepEdges = Sines(Steps, 0.0);

    private readonly SphereOutline _outline;
    private readonly double _radius;
    private readonly double _distance;

    /// <summary>Direction of the sphere's centre: components forward, right and up.</summary>
    private readonly Vector3D _toCentre;

    /// <summary>Direction of the light from the sphere's centre; components as above.</summary>
    private readonly Vector3D _toLight;

    /// <summary>Distance over the centre, in radii towards the light, at which the light is on the horizon.</summary>
    private readonly double _horizon;

    private SphereCoverage(FrameCamera camera, Vector3D lightBodyFixed, double radius)
    {
        _radius = radius;
        _distance = camera.PositionBodyFixed.Length;
        _toCentre = ForwardRightUp(camera, -camera.PositionBodyFixed / _distance);
        double lightDistance = lightBodyFixed.Length;
        _toLight = ForwardRightUp(camera, lightBodyFixed / lightDistance);
        _horizon = radius / lightDistance;
        _outline = new SphereOutline(_toCentre, radius, _distance, ImageOf(camera));
    }

    /// <summary>Measures a sphere around the Moon's centre.</summary>
    /// <param name="camera">The camera; inside the sphere it sees nothing of it.</param>
    /// <param name="light">The Sun; a lamp at the camera lights all that is seen.</param>
    /// <param name="radius">Radius, m.</param>
    public static SphereShare Of(FrameCamera camera, SceneLight light, double radius)
    {
        if (!(camera.PositionBodyFixed.Length >= radius))
        {
            return new SphereShare(0.0, Lit: null);
        }

        SphereCoverage coverage = new(camera, light.PositionBodyFixed, radius);
        if (coverage._outline.TryFindRows(out double bottom, out double top) && coverage.Moon(bottom, top) is > 0.0 and var moon)
        {
            double? uniform = light.IsSun ? UniformLight(camera.PositionBodyFixed, light.PositionBodyFixed, radius) : 1.0;
            return new SphereShare(Math.Min(1.0, moon), uniform ?? coverage.Lit(bottom, top));
        }

        return new SphereShare(0.0, Lit: null);
    }

    /// <summary>
    /// 1 or 0 if it is day or night on all that can be seen from a position, in whatever direction; null if both are there. This decides
    /// most frames from a low orbit.
    /// </summary>
    private static double? UniformLight(Vector3D positionBodyFixed, Vector3D lightBodyFixed, double radius)
    {
        double toHorizon = AngleToHorizon(positionBodyFixed.Length, radius);
        double toTerminator = AngleToHorizon(lightBodyFixed.Length, radius);
        double between = Vector3D.AngleBetween(positionBodyFixed.Normalized(), lightBodyFixed.Normalized());
        return between + toHorizon <= toTerminator ? 1.0 : between - toHorizon >= toTerminator ? 0.0 : null;
    }

    /// <summary>Angle at the centre from the point below something to where it is on the horizon, rad.</summary>
    private static double AngleToHorizon(double distance, double radius) =>
        Math.Atan2(Math.Sqrt(Math.Max(0.0, distance - radius) * (distance + radius)), radius);

    /// <summary>Part of the image that shows the sphere.</summary>
    private double Moon(double bottom, double top)
    {
        double area = 0.0;
        for (int row = 0; row < Rows; row++)
        {
            (double from, double to) = _outline.Interval(SphereOutline.At(bottom, top, RowMiddles[row]));
            area += 0.5 * (top - bottom) * (RowEdges[row + 1] - RowEdges[row]) * (to - from);
        }

        return area / _outline.ImageArea;
    }

    /// <summary>Part of what is seen of the sphere that is lit.</summary>
    private double Lit(double bottom, double top)
    {
        Span<double> below = stackalloc double[Steps + 1];
        Span<double> above = stackalloc double[Steps + 1];
        double seen = 0.0;
        double lit = 0.0;
        double widthBelow = Sample(bottom, below);
        for (int row = 0; row < Rows; row++)
        {
            double widthAbove = Sample(SphereOutline.At(bottom, top, RowEdges[row + 1]), above);
            double strip = (RowEdges[row + 1] - RowEdges[row]) * (widthBelow + widthAbove);
            for (int step = 0; step < Steps; step++)
            {
                double cell = strip * (StepEdges[step + 1] - StepEdges[step]);
                seen += cell;
                lit += 0.5 * cell * (PositivePart.OfTriangle(below[step], below[step + 1], above[step])
                    + PositivePart.OfTriangle(above[step + 1], below[step + 1], above[step]));
            }

            widthBelow = widthAbove;
            above.CopyTo(below);
        }

        return Math.Min(1.0, lit / seen);
    }

    /// <summary>Samples the light along a row.</summary>
    /// <returns>The length of the row's interval.</returns>
    private double Sample(double b, Span<double> light)
    {
        (double from, double to) = _outline.Interval(b);
        for (int step = 0; step <= Steps; step++)
        {
            light[step] = LightOver(SphereOutline.At(from, to, StepEdges[step]), b);
        }

        return to - from;
    }

    /// <summary>
    /// How far the point of the sphere that a ray shows lies on the lit side, in radii: positive by day, negative at night.
    /// </summary>
    private double LightOver(double a, double b)
    {
        double length = Math.Sqrt(1.0 + (a * a) + (b * b));
        Vector3D ray = new(1.0 / length, a / length, b / length);

        // Sines, whose rounding by 1e-16 does not matter here: Vector3D.Cross and Length would take most of the time.
        double x = (ray.Y * _toCentre.Z) - (ray.Z * _toCentre.Y);
        double y = (ray.Z * _toCentre.X) - (ray.X * _toCentre.Z);
        double z = (ray.X * _toCentre.Y) - (ray.Y * _toCentre.X);
        double sine = _distance * Math.Sqrt((x * x) + (y * y) + (z * z));
        double halfChord = Math.Sqrt(Math.Max(0.0, (_radius - sine) * (_radius + sine)));
        double range = (_distance * Vector3D.Dot(ray, _toCentre)) - halfChord;
        return (((range * Vector3D.Dot(ray, _toLight)) - (_distance * Vector3D.Dot(_toCentre, _toLight))) / _radius) - _horizon;
    }

    /// <summary>The image; of a lens a rectangle through the middles of its borders.</summary>
    private static TangentBox ImageOf(FrameCamera camera)
    {
        if (camera.Model.IsThesis)
        {
            (double right, double up) = (0.5 * camera.Width * camera.PixelTangent, 0.5 * camera.Height * camera.PixelTangent);
            return new TangentBox(-right, -up, right, up);
        }

        (double x, double y) = (0.5 * (1.0 + camera.Width), 0.5 * (1.0 + camera.Height));
        return new TangentBox(
            camera.Model.ToIdeal(0.5, y).Right,
            camera.Model.ToIdeal(x, 0.5).Down,
            camera.Model.ToIdeal(camera.Width + 0.5, y).Right,
            camera.Model.ToIdeal(x, camera.Height + 0.5).Down);
    }

    /// <summary>Camera axes look along -x, with y to the right and z up.</summary>
    private static Vector3D ForwardRightUp(FrameCamera camera, Vector3D directionBodyFixed)
    {
        Vector3D inCamera = camera.MoonFromCamera.Conjugate * directionBodyFixed;
        return inCamera with { X = -inCamera.X };
    }

    /// <summary>The sines of equal steps from -90 to 90 degrees, moved on by a part of a step.</summary>
    private static double[] Sines(int count, double offset) =>
        [.. Enumerable.Range(0, count + 1).Select(i => Math.Sin(((i + offset) / count * Math.PI) - (0.5 * Math.PI)))];
}

/// <summary>How much of an area a function is positive on, from its values at the corners.</summary>
internal static class PositivePart
{
    /// <summary>The part of a triangle on which a linear function is not negative.</summary>
    /// <param name="a">Its value at a corner.</param>
    /// <param name="b">At another one.</param>
    /// <param name="c">At the third.</param>
    /// <returns>0 to 1; above 0 if one of the values is.</returns>
    public static double OfTriangle(double a, double b, double c) => ((a >= 0.0 ? 1 : 0) + (b >= 0.0 ? 1 : 0) + (c >= 0.0 ? 1 : 0)) switch
    {
        3 => 1.0,
        0 => 0.0,
        1 => a >= 0.0 ? AtCorner(a, b, c) : b >= 0.0 ? AtCorner(b, a, c) : AtCorner(c, a, b),
        _ => 1.0 - (a < 0.0 ? AtCorner(a, b, c) : b < 0.0 ? AtCorner(b, a, c) : AtCorner(c, a, b)),
    };

    /// <summary>The part on the side of the one corner whose value has another sign than the other two.</summary>
    private static double AtCorner(double corner, double other, double third) =>
        corner / (corner - other) * (corner / (corner - third));
}
