namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The pixels of one row that show the surface, from left to right, with one array for each quantity; one object is used for many rows.
/// </summary>
internal sealed class SurfaceRow
{
    /// <summary>
    /// Elements after the last pixel, with finite values, so that whole vectors can be read and written from any pixel without range
    /// checks.
    /// </summary>
    public const int Padding = 8;

    /// <summary>Number of pixels that show the surface.</summary>
    public int Count { get; internal set; }

    /// <summary>Column of each pixel, from 0.</summary>
    public int[] Columns { get; private set; } = [];

    /// <summary>Index of each pixel's facet, for <see cref="VisibleSurface.FacetOf"/>; equal indices are equal facets.</summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>Ray parameter t of each pixel's point: camera + t direction.</summary>
    public double[] Parameters { get; private set; } = [];

    /// <summary>Coordinate of each pixel's surface point, m, body-fixed.</summary>
    public double[] X { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; private set; } = [];

    /// <summary>Component of each facet's outward unit normal, body-fixed.</summary>
    public double[] NormalX { get; private set; } = [];

    /// <inheritdoc cref="NormalX"/>
    public double[] NormalY { get; private set; } = [];

    /// <inheritdoc cref="NormalX"/>
    public double[] NormalZ { get; private set; } = [];

    /// <summary>Makes the arrays large enough for an image's width.</summary>
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
