using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>The buffers with which one thread draws bands.</summary>
internal sealed class BandWorker
{
    private readonly ProjectedBlock _block = new();
    private readonly CellRasterizer _sieve = new();
    private readonly NearPlaneCells _crossing = new();
    private readonly List<VisibleBlock> _touching = [];
    private double[] _sampleColumns = [];
    private double[] _sampleRows = [];
    private int _facets; // of the last band

    /// <summary>Draws all blocks that touch a band and returns how much work that was.</summary>
    public VisibilityCounts Draw(SurfaceModel surface, ImageView view, IReadOnlyList<VisibleBlock> blocks, Band band)
    {
        long read = 0;
        long sieved = 0;
        Begin(view, band);
        foreach (VisibleBlock visible in blocks)
        {
            if (visible.Rows.First > band.LastRow || visible.Rows.End <= band.FirstRow)
            {
                continue;
            }

            _block.Read(surface, visible.Block, view);
            read++;
            sieved += DrawBlock<PixelCentres>(view, band);
        }

        _facets = band.Records.Count;
        return new VisibilityCounts(0, read, sieved, _facets);
    }

    /// <summary>Draws all blocks that touch a band of an image with a lens, each tile by tile.</summary>
    /// <param name="view">The projection without the lens.</param>
    /// <param name="blocks">The blocks that the image may show.</param>
    public VisibilityCounts Draw(
        SurfaceModel surface, ImageView view, LensSamples lens, int index, List<VisibleBlock> blocks, Band band)
    {
        _touching.Clear();
        double width = 0.0;
        foreach (VisibleBlock visible in blocks)
        {
            if (visible.Tangents.Meets(lens.TangentsOf(index)))
            {
                _touching.Add(visible);
                width += Math.Sqrt(Math.Max(0.0, visible.Tangents.Area));
            }
        }

        // One division for the whole band: a sample must see both sides of an edge in the same plane.
        double cell = width * view.PixelsPerTangent / (_touching.Count * CellBlock.Size);
        IReadOnlyList<LensTile> tiles = lens.TilesOf(index, cell);
        band.Place(tiles, lens, ref _sampleColumns, ref _sampleRows);
        ImageView[] views = [.. tiles.Select(tile => new ImageView(view.Camera, lens, tile))];
        Begin(view, band);
        long sieved = 0;
        foreach (VisibleBlock visible in _touching)
        {
            _block.Read(surface, visible.Block, view);
            for (int tile = 0; tile < views.Length; tile++)
            {
                if (visible.Tangents.Meets(tiles[tile].Tangents))
                {
                    band.Narrow(tiles[tile]);
                    _crossing.Begin(views[tile]);
                    sieved += DrawBlock<AnySamples>(views[tile], band);
                }
            }
        }

        _facets = band.Records.Count;
        return new VisibilityCounts(0, _touching.Count, sieved, _facets);
    }

    private void Begin(ImageView view, Band band)
    {
        band.Records.Expect(RecentUse.WithReserve(_facets));
        _sieve.Begin(view);
        _crossing.Begin(view);
    }

    private long DrawBlock<TSamples>(ImageView view, Band band)
        where TSamples : struct, ISampleKind
    {
        _block.Project(view);
        return _block.IsInFront ? _sieve.Draw<TSamples>(_block, band) : _crossing.DrawAll<TSamples>(_block, band);
    }
}
