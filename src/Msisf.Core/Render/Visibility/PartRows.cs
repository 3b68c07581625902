using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>Points of parts of pixels, laid out in rows, so that light and shade are found for them as for pixels.</summary>
internal sealed class PartRows : ISurfaceRows
{
    private readonly List<(PixelParts Parts, FacetPoints Points, int First)> _rows = [];
    private RowResolver _resolver = null!;

    public int Width => RowLength;

    public int Height => _rows.Count;

    public ImageView View { get; private set; } = null!;

    /// <summary>Number of points in a row; the last row of a band may have fewer.</summary>
    public const int RowLength = 1024;

    /// <summary>Starts with no points.</summary>
    public void Begin(ImageView view)
    {
        View = view;
        _rows.Clear();
        _resolver = new RowResolver(view, lens: null);
    }

    /// <summary>Adds points of the facets of a band and returns their first row.</summary>
    public int Add(PixelParts parts, FacetPoints points)
    {
        int row = _rows.Count;
        for (int first = 0; first < points.Count; first += RowLength)
        {
            _rows.Add((parts, points, first));
        }

        return row;
    }

    public void Read(int y, SurfaceRow row)
    {
        (PixelParts parts, FacetPoints points, int first) = _rows[y - 1];
        _resolver.Resolve(parts.Records, points, first, Math.Min(RowLength, points.Count - first), row);
    }

    public void ReadPoints(int y, ReadOnlySpan<int> columns, SurfaceRow row)
    {
        (PixelParts parts, FacetPoints points, int first) = _rows[y - 1];
        _resolver.Resolve(parts.Records, points, first, columns, row);
    }

    public FacetId FacetOf(int y, int number) => _rows[y - 1].Parts.Records[number].Facet;
}
