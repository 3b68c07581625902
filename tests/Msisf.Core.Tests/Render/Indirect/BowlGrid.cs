using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>A bowl that is a part of a sphere, in a plane, around the north pole.</summary>
internal sealed class BowlGrid : ITerrainGrid
{
    /// <summary>m: diameter of the bowl.</summary>
    public const double Diameter = 2000.0;

    private const double Radius = 1_737_400.0;
    private readonly double[] _radii;

    /// <param name="depth">Depth over <see cref="Diameter"/>.</param>
    /// <param name="cells">Cells across the bowl.</param>
    public BowlGrid(double depth, int cells)
    {
        double scale = Diameter / cells;
        Lines = (3 * cells) | 1;
        double middle = (Lines - 1) / 2.0;
        double deep = depth * Diameter;
        double curvature = ((Diameter * Diameter / 4.0) + (deep * deep)) / (2.0 * deep);
        Projection = new PolarStereographic(false, scale, middle, middle);
        _radii = [.. Enumerable.Range(0, Lines * Lines).Select(index =>
        {
            // From the map to the plane that touches the sphere at the pole.
            double angle = 2.0 * Math.Atan(scale * double.Hypot((index / Lines) - middle, (index % Lines) - middle) / (2.0 * Radius));
            double across = Radius * Math.Tan(angle);
            double below = across < Diameter / 2.0 ? Math.Sqrt((curvature * curvature) - (across * across)) - (curvature - deep) : 0.0;
            return (Radius - below) / Math.Cos(angle);
        })];
    }

    public string ProductId => "BOWL";

    public MapProjection Projection { get; }

    public int Lines { get; }

    public int Samples => Lines;

    public (double Min, double Max) RadiusLimits => (_radii.Min() - 1.0, _radii.Max() + 1.0);

    public void ReadRadii(int line, int firstSample, Span<double> radii) =>
        _radii.AsSpan((line * Lines) + firstSample, radii.Length).CopyTo(radii);
}
