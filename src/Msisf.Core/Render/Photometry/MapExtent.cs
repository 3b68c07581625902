namespace Msisf.Core.Render.Photometry;

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
