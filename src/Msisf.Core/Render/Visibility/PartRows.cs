using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>The parts of the pixels of some bands, laid out in rows, so that light and shade are found for them as for pixels.</summary>
internal sealed class PartRows : ISurfaceRows
{
    private readonly List<(PixelParts Parts, int First)> _rows = [];
    private RowResolver _resolver = null!;

    public int Width => RowLength;

    public int Height => _rows.Count;

    public ImageView View { get; private set; } = null!;

    /// <summary>Number of parts in a row; the last row of a band may have fewer.</summary>
    public const int RowLength = 1024;

    /// <summary>Starts with no parts.</summary>
    public void Begin(ImageView view)
    {
        View = view;
        _rows.Clear();
        _resolver = new RowResolver(view, lens: null);
    }

    /// <summary>Adds the parts of a band and returns their first row.</summary>
    public int Add(PixelParts parts)
    {
        int row = _rows.Count;
        for (int first = 0; first < parts.Count; first += RowLength)
        {
            _rows.Add((parts, first));
        }

        return row;
    }

    public void Read(int y, SurfaceRow row)
    {
        (PixelParts parts, int first) = _rows[y - 1];
        _resolver.Resolve(parts, first, Math.Min(RowLength, parts.Count - first), row);
    }

    public void ReadPoints(int y, ReadOnlySpan<int> columns, SurfaceRow row)
    {
        (PixelParts parts, int first) = _rows[y - 1];
        _resolver.Resolve(parts, first, columns, row);
    }

    public FacetId FacetOf(int y, int number) => _rows[y - 1].Parts.Records[number].Facet;
}
