namespace Msisf.Core.Render.Visibility;

/// <summary>How much work a frame was; the same for every number of threads.</summary>
/// <param name="VisibleBlocks">Blocks that may be seen.</param>
/// <param name="BlocksRead">Blocks that were read, once for each band of rows that they touch.</param>
/// <param name="CellsSieved">Cells that were looked at.</param>
/// <param name="FacetsDrawn">Facets that won a pixel, at least for a while.</param>
internal readonly record struct VisibilityCounts(int VisibleBlocks, long BlocksRead, long CellsSieved, long FacetsDrawn)
{
    public static VisibilityCounts operator +(VisibilityCounts a, VisibilityCounts b) => new(
        a.VisibleBlocks + b.VisibleBlocks, a.BlocksRead + b.BlocksRead, a.CellsSieved + b.CellsSieved, a.FacetsDrawn + b.FacetsDrawn);
}
