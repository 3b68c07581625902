using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>Ground over the plane that touches the sphere at the north pole.</summary>
internal sealed class PlaneGrid : ITerrainGrid
{
    /// <summary>m: diameter of the bowls.</summary>
    public const double Diameter = 2000.0;

    private const double Radius = 1_737_400.0;
    private readonly double[] _radii;

    /// <param name="scale">m from vertex to vertex.</param>
    /// <param name="lines">Lines and samples, an odd number.</param>
    /// <param name="height">Height over the plane, m, at two coordinates in it, m: x along longitude 0, y along 90 degrees east.</param>
    public PlaneGrid(double scale, int lines, Func<double, double, double> height)
    {
        Lines = lines;
        double middle = (lines - 1) / 2.0;
        Projection = new PolarStereographic(false, scale, middle, middle);
        _radii = [.. Enumerable.Range(0, lines * lines).Select(index =>
        {
            // From the map to the plane.
            (double right, double down) = (scale * ((index % lines) - middle), scale * ((index / lines) - middle));
            double angle = 2.0 * Math.Atan(double.Hypot(right, down) / (2.0 * Radius));
            double stretch = angle == 0.0 ? 1.0 : Radius * Math.Tan(angle) / double.Hypot(right, down);
            return (Radius + height(stretch * down, stretch * right)) / Math.Cos(angle);
        })];
    }

    public string ProductId => "PLANE";

    public MapProjection Projection { get; }

    public int Lines { get; }

    public int Samples => Lines;

    public (double Min, double Max) RadiusLimits => (_radii.Min() - 1.0, _radii.Max() + 1.0);

    /// <summary>
    /// A bowl that is a part of a sphere, around the pole. Facets cut its rim off, where much of the light of a low Sun falls: with 200
    /// cells 0.6 % of the light in the shadow is missing (depth 0.2, the Sun at 10 degrees), with 500 0.2 %, with 2000 0.02 %.
    /// </summary>
    /// <param name="depth">Depth over <see cref="Diameter"/>.</param>
    /// <param name="cells">Cells across the bowl.</param>
    public static PlaneGrid Bowl(double depth, int cells)
    {
        double deep = depth * Diameter;
        double curvature = ((Diameter * Diameter / 4.0) + (deep * deep)) / (2.0 * deep);
        return new PlaneGrid(Diameter / cells, (3 * cells / 2) | 1, (x, y) => double.Hypot(x, y) < Diameter / 2.0
            ? curvature - deep - Math.Sqrt((curvature * curvature) - (x * x) - (y * y))
            : 0.0);
    }

    public void ReadRadii(int line, int firstSample, Span<double> radii) =>
        _radii.AsSpan((line * Lines) + firstSample, radii.Length).CopyTo(radii);
}
