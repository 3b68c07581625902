using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>The buffers with which one thread draws bands.</summary>
internal sealed class BandWorker
{
    private readonly ProjectedBlock _block = new();
    private readonly CellSieve _sieve = new();
    private readonly NearPlaneCells _crossing = new();

    private double[] _sampleColumns = [];
    private double[] _sampleRows = [];

    /// <summary>Draws all blocks that touch a band and returns how much work that was.</summary>
    public VisibilityCounts Draw(SurfaceModel surface, ImageView view, List<VisibleBlock> blocks, Band band)
    {
        long read = 0;
        long sieved = 0;
        Begin(view);
        foreach (VisibleBlock visible in blocks)
        {
            if (visible.Rows.First > band.LastRow || visible.Rows.End <= band.FirstRow)
            {
                continue;
            }

            read++;
            sieved += DrawBlock<PixelCentres>(surface, visible.Block, view, band);
        }

        return new VisibilityCounts(0, read, sieved, band.RecordCount);
    }

    /// <summary>Draws all blocks that touch a band of an image with a lens, tile by tile.</summary>
    public VisibilityCounts Draw(
        SurfaceModel surface, ImageView view, LensSamples lens, IReadOnlyList<LensTile> tiles, List<VisibleBlock> blocks, Band band)
    {
        long read = 0;
        long sieved = 0;
        foreach (LensTile tile in tiles)
        {
            ImageView tileView = new(view.Camera, view.OffsetX, view.OffsetY, lens, tile);
            Begin(tileView);
            band.Narrow(tile, lens, ref _sampleColumns, ref _sampleRows);
            foreach (VisibleBlock visible in blocks)
            {
                if (visible.Tangents.Meets(tile.Tangents))
                {
                    read++;
                    sieved += DrawBlock<AnySamples>(surface, visible.Block, tileView, band);
                }
            }
        }

        return new VisibilityCounts(0, read, sieved, band.RecordCount);
    }

    private void Begin(ImageView view)
    {
        _sieve.Begin(view);
        _crossing.Begin(view);
    }

    private long DrawBlock<TSamples>(SurfaceModel surface, CellBlock block, ImageView view, Band band)
        where TSamples : struct, ISampleKind
    {
        _block.Load(surface, block, view);
        return _block.IsInFront ? _sieve.Draw<TSamples>(_block, band) : _crossing.DrawAll<TSamples>(_block, band);
    }
}
