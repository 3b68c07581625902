namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The pixels of one row that show the surface, from left to right, one array for each number; one object is filled again and again.
/// </summary>
internal sealed class SurfaceRow
{
    /// <summary>
    /// Elements behind the last, so that whole vectors can be read and written from any pixel on without range checks; they are finite.
    /// </summary>
    public const int Padding = 8;

    /// <summary>Pixels that show the surface.</summary>
    public int Count { get; internal set; }

    /// <summary>Column of each pixel, from 0.</summary>
    public int[] Columns { get; private set; } = [];

    /// <summary>Number of each pixel's facet, for <see cref="VisibleSurface.FacetOf"/>; equal numbers are equal facets.</summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>t of camera + t direction.</summary>
    public double[] Parameters { get; private set; } = [];

    /// <summary>m, MOON_ME.</summary>
    public double[] X { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; private set; } = [];

    /// <summary>Of the facet, outward, MOON_ME, length 1.</summary>
    public double[] NormalX { get; private set; } = [];

    /// <inheritdoc cref="NormalX"/>
    public double[] NormalY { get; private set; } = [];

    /// <inheritdoc cref="NormalX"/>
    public double[] NormalZ { get; private set; } = [];

    /// <summary>Makes room for an image's width.</summary>
    internal void EnsureWidth(int width)
    {
        int size = width + Padding;
        if (Columns.Length < size)
        {
            Columns = new int[size];
            Facets = new int[size];
            (Parameters, X, Y, Z) = (new double[size], new double[size], new double[size], new double[size]);
            (NormalX, NormalY, NormalZ) = (new double[size], new double[size], new double[size]);
        }
    }
}
