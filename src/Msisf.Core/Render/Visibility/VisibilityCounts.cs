namespace Msisf.Core.Render.Visibility;

/// <summary>Counts of the work for a frame; they do not depend on the number of threads.</summary>
/// <param name="VisibleBlocks">Number of blocks that may be visible.</param>
/// <param name="BlocksRead">Number of block reads; a block is read once for each band of rows that it touches.</param>
/// <param name="CellsSieved">Number of cells that were tested.</param>
/// <param name="FacetsDrawn">Number of facets that were the nearest one at some pixel, at least temporarily.</param>
internal readonly record struct VisibilityCounts(int VisibleBlocks, long BlocksRead, long CellsSieved, long FacetsDrawn)
{
    public static VisibilityCounts operator +(VisibilityCounts a, VisibilityCounts b) => new(
        a.VisibleBlocks + b.VisibleBlocks, a.BlocksRead + b.BlocksRead, a.CellsSieved + b.CellsSieved, a.FacetsDrawn + b.FacetsDrawn);
}
