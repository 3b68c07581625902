using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in several files, row by row across all of them. Where no tile lies there is no data.</summary>
internal sealed class TiledMapSource : MapSource
{
    private readonly MapTileLayout _layout;
    private readonly List<PdsMapSource> _sources = [];
    private float[] _rows = [];

    /// <summary>Opens the images of all tiles.</summary>
    /// <exception cref="Core.Errors.BadInputException">An image is missing, unreadable, or shorter than its label says.</exception>
    public TiledMapSource(MapTileLayout layout)
    {
        _layout = layout;
        try
        {
            _sources.AddRange(layout.Tiles.Select(tile => new PdsMapSource(tile.Label)));
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    /// <inheritdoc/>
    public override int Width => _layout.Width;

    /// <inheritdoc/>
    public override int Height => _layout.Height;

    /// <inheritdoc/>
    public override MapExtent? Extent => _layout.Extent;

    /// <inheritdoc/>
    public override bool IsBytes => _sources[0].IsBytes;

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        values[..(count * Width)].Fill(float.NaN);
        foreach ((PlacedMapTile tile, PdsMapSource source) in _layout.Tiles.Zip(_sources))
        {
            int start = Math.Max(first, tile.Row);
            int rows = Math.Min(first + count, tile.Row + source.Height) - start;
            if (rows <= 0)
            {
                continue;
            }

            if (_rows.Length < rows * source.Width)
            {
                _rows = new float[rows * source.Width];
            }

            source.Read(start - tile.Row, rows, _rows);
            for (int row = 0; row < rows; row++)
            {
                _rows.AsSpan(row * source.Width, source.Width).CopyTo(values[(((start - first + row) * Width) + tile.Column)..]);
            }
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _sources.ForEach(source => source.Dispose());
}
