using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Photometry;

/// <summary>A map of the Moon's reflectance at one geometry of light and view, with its coarser levels. Immutable.</summary>
public sealed class AlbedoMap
{
    /// <summary>1: by so much the cosine of the cap around a map is less, for rounding.</summary>
    private const double CapSlack = 1e-9;

    private readonly Vector3D _middle;
    private readonly double _cosReach;

    /// <summary>Takes a map.</summary>
    /// <param name="levels">Finest first, each half as wide and high as the one before.</param>
    /// <param name="extent">What the map shows.</param>
    /// <param name="offset">Reflectance of the code 0 (which itself means no data).</param>
    /// <param name="step">Reflectance of a step of the code.</param>
    /// <param name="reference">The geometry of the reflectances.</param>
    public AlbedoMap(
        IReadOnlyList<AlbedoMapLevel> levels, MapExtent extent, double offset, double step, ReferenceGeometry reference)
    {
        Levels = levels;
        Extent = extent;
        Offset = offset;
        Step = step;
        Reference = reference;
        (_middle, _cosReach) = CapOf(extent);
    }

    /// <summary>Finest first.</summary>
    public IReadOnlyList<AlbedoMapLevel> Levels { get; }

    /// <summary>What the map shows.</summary>
    public MapExtent Extent { get; }

    /// <summary>Reflectance of the code 0.</summary>
    public double Offset { get; }

    /// <summary>Reflectance of a step of the code.</summary>
    public double Step { get; }

    /// <summary>The geometry of the reflectances.</summary>
    public ReferenceGeometry Reference { get; }

    /// <summary>The same map with other reflectances.</summary>
    /// <param name="factor">By what they are multiplied.</param>
    /// <param name="reference">Their geometry of light and view.</param>
    public AlbedoMap Scaled(double factor, ReferenceGeometry reference) =>
        new(Levels, Extent, factor * Offset, factor * Step, reference);

    /// <summary>Whether points may lie on the map; a quick test, which points beside it pass too.</summary>
    internal bool MayHold(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z)
    {
        for (int i = 0; i < x.Length; i++)
        {
            double along = (x[i] * _middle.X) + (y[i] * _middle.Y) + (z[i] * _middle.Z);
            if (along >= _cosReach * Math.Sqrt((x[i] * x[i]) + (y[i] * y[i]) + (z[i] * z[i])))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The direction of a map's middle, and the cosine of the angle to its farthest corner.</summary>
    private static (Vector3D Middle, double CosReach) CapOf(MapExtent extent)
    {
        Vector3D At(double right, double down) => new SelenographicPoint(
            Math.Clamp(extent.North - (down * extent.Height), -Math.PI / 2.0, Math.PI / 2.0),
            extent.West + (right * extent.Width)).ToDirectionBodyFixed();
        if (extent.Width > Math.PI)
        {
            return extent.North - extent.Height > 0.0 ? (new Vector3D(0.0, 0.0, 1.0), Math.Sin(extent.North - extent.Height) - CapSlack)
                : extent.North < 0.0 ? (new Vector3D(0.0, 0.0, -1.0), Math.Sin(-extent.North) - CapSlack)
                : (new Vector3D(0.0, 0.0, 1.0), -2.0);
        }

        Vector3D middle = At(0.5, 0.5);
        return (middle, Math.Min(Vector3D.Dot(middle, At(0.0, 0.0)), Vector3D.Dot(middle, At(0.0, 1.0))) - CapSlack);
    }
}

/// <summary>A level of a map: the same extent with fewer pixels, each the mean of its area.</summary>
/// <param name="Width">Pixels from west to east.</param>
/// <param name="Height">Pixels from north to south.</param>
/// <param name="Codes">The values, row by row from the north-west; 0 is no data, others are linear in the reflectance.</param>
public sealed record AlbedoMapLevel(int Width, int Height, ReadOnlyMemory<ushort> Codes)
{
    /// <summary>The size of the next coarser level; the same size if there is none.</summary>
    public static (int Width, int Height) Below(int width, int height) => ((width + 1) / 2, (height + 1) / 2);
}

/// <summary>The part of the Moon that an equirectangular map shows; longitudes east, all in rad.</summary>
/// <param name="West">Longitude of the left edge.</param>
/// <param name="North">Latitude of the upper edge.</param>
/// <param name="Width">From the left edge to the right edge, up to 2 pi.</param>
/// <param name="Height">From the upper edge to the lower edge, up to pi.</param>
public readonly record struct MapExtent(double West, double North, double Width, double Height)
{
    /// <summary>rad: labels round their edges to fractions of a pixel; a gap smaller than this is none.</summary>
    private const double Seam = 1e-6;

    /// <summary>All of the Moon, with the prime meridian as left edge.</summary>
    public static MapExtent WholeMoon => new(0.0, Math.PI / 2.0, 2.0 * Math.PI, Math.PI);

    /// <summary>The left and the right edge are the same meridian.</summary>
    public bool IsFullCircle => Width > (2.0 * Math.PI) - Seam;

    /// <summary>The upper edge is the north pole.</summary>
    public bool ReachesNorthPole => IsFullCircle && North > (Math.PI / 2.0) - Seam;

    /// <summary>The lower edge is the south pole.</summary>
    public bool ReachesSouthPole => IsFullCircle && North - Height < (-Math.PI / 2.0) + Seam;
}
