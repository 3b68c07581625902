using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>Finds the cells of a model that belong to the surface: those with data, beyond the reach of all finer models.</summary>
internal static class KeptCells
{
    /// <summary>
    /// Minimum distance of the cells of a coarser model from those of a finer one, in its own cells: seams are neither narrow nor wide.
    /// </summary>
    private const double Gap = 0.4;

    /// <summary>Finds the cells.</summary>
    /// <param name="part">The model.</param>
    /// <param name="finer">The finer models, with their own cells.</param>
    public static CellMask Of(GridPatch part, IReadOnlyList<GridPatch> finer)
    {
        CellMask mask = new(part.Mesh);
        RemoveGaps(part, mask);
        foreach (GridPatch other in finer)
        {
            ReachedCells reached = new(part, mask, other);
            NodeWalk.All(part.Layout, ref reached);
        }

        RemoveFans(part.Mesh, mask);
        mask.Seal();
        return mask;
    }

    /// <summary>Removes the cells with a corner that has no data.</summary>
    private static void RemoveGaps(GridPatch part, CellMask mask)
    {
        if (!part.Grid.MayHaveGaps)
        {
            return;
        }

        CellRange all = part.Mesh.Cells;
        GridWindow window = part.Grid.Window;
        bool[] gaps = new bool[window.Samples];
        for (int line = window.FirstLine; line < window.EndLine; line++)
        {
            if (!part.Grid.MayHaveGapsIn(line, 1, window.FirstSample, window.Samples))
            {
                continue;
            }

            part.Grid.ReadGaps(line, window.FirstSample, gaps);
            for (int at = Array.IndexOf(gaps, true); at >= 0; at = Array.IndexOf(gaps, true, at + 1))
            {
                int sample = window.FirstSample + at;
                foreach (int left in (int[])[part.Mesh.NeighboursOf(sample).West, sample])
                {
                    for (int up = Math.Max(line - 1, all.FirstLine); up <= Math.Min(line, all.EndLine - 1); up++)
                    {
                        if (left < all.EndSample)
                        {
                            mask.Remove(up, left);
                        }
                    }
                }
            }
        }
    }

    /// <summary>Removes the whole fan around a pole if a part of it is gone, so that the pole is not a corner of a border.</summary>
    private static void RemoveFans(FacetMesh mesh, CellMask mask)
    {
        foreach (int line in mesh.IsClosed ? (int[])[-1, mesh.SouthFanLine] : [])
        {
            if (!mask.HasAll(new CellRange(line, line + 1, 0, mesh.Samples)))
            {
                for (int sample = 0; sample < mesh.Samples; sample++)
                {
                    mask.Remove(line, sample);
                }
            }
        }
    }

    /// <summary>Removes the cells within reach of a finer model.</summary>
    private readonly struct ReachedCells(GridPatch part, CellMask mask, GridPatch finer) : INodeTester
    {
        public Visit Test(NodePlace node)
        {
            (int level, int row, int column) = node;
            double margin = Gap * part.CellAngle;
            CellRange[] reached = CapWindow.Of(finer.Mesh, part.Bounds.CapOf(level, row, column), margin);
            if (!Array.Exists(reached, finer.Kept!.HasAny))
            {
                return Visit.Skip;
            }

            if (level > SquareLayout.CellBlockLevel)
            {
                return Visit.Descend;
            }

            if (mask.StateOf(row, column) != CellMask.BlockState.Empty && finer.Kept.HasAll(reached[0]))
            {
                mask.RemoveBlock(row, column);
            }

            if (mask.StateOf(row, column) == CellMask.BlockState.Empty)
            {
                return Visit.Skip;
            }

            CellRange cells = part.Layout.Cells(level, row, column);
            for (int line = cells.FirstLine; line < cells.EndLine; line++)
            {
                for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
                {
                    SphericalCap cap = part.Bounds.CapOf(new CellRange(line, line + 1, sample, sample + 1));
                    if (Array.Exists(CapWindow.Of(finer.Mesh, cap, margin), finer.Kept.HasAny))
                    {
                        mask.Remove(line, sample);
                    }
                }
            }

            return Visit.Skip;
        }
    }
}
