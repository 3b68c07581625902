using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>The buffers with which one thread draws bands.</summary>
internal sealed class BandWorker
{
    private readonly ProjectedBlock _block = new();
    private readonly CellSieve _sieve = new();
    private readonly NearPlaneCells _crossing = new();

    /// <summary>Draws all blocks that touch a band and returns how much work that was.</summary>
    public VisibilityCounts Draw(SurfaceModel surface, ImageView view, List<VisibleBlock> blocks, Band band)
    {
        long read = 0;
        long sieved = 0;
        _sieve.Begin(view);
        _crossing.Begin(view);
        foreach (VisibleBlock visible in blocks)
        {
            if (visible.Rows.First > band.LastRow || visible.Rows.End <= band.FirstRow)
            {
                continue;
            }

            _block.Load(surface, visible.Block, view);
            read++;
            sieved += _block.IsInFront ? _sieve.Draw(_block, band) : _crossing.DrawAll(_block, band);
        }

        return new VisibilityCounts(0, read, sieved, band.RecordCount);
    }
}
