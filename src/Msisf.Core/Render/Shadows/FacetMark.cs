using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Marks the bins of receivers that one facet may darken, if each receiver stands for points up to a bin around it.</summary>
internal static class FacetMark
{
    /// <summary>Marks the bins.</summary>
    /// <param name="facet">A facet that faces away from the Sun.</param>
    /// <param name="grid">The receivers, with the depth of the deepest of their points.</param>
    public static void WantBins(in LightFacet facet, ReceiverGrid grid)
    {
        LightBox box = facet.Box;
        GridRange bins = grid.BinsOf(in box).WithNeighbours(grid.Size);
        double minDepth = facet.MinDepth;
        if (!(minDepth < grid.MaxDepth(bins)))
        {
            return;
        }

        (double ub, double vb, double wb) = (facet.Ub - facet.Ua, facet.Vb - facet.Va, facet.Wb - facet.Wa);
        (double uc, double vc, double wc) = (facet.Uc - facet.Ua, facet.Vc - facet.Va, facet.Wc - facet.Wa);
        double area = (ub * vc) - (uc * vb);
        double perU = ((wb * vc) - (wc * vb)) / area;
        double perV = ((wc * ub) - (wb * uc)) / area;
        double rounding = Tolerances.LightPoint * (1.0 + Math.Abs(perU) + Math.Abs(perV));
        for (int row = bins.FirstRow; row <= bins.LastRow; row++)
        {
            (double minV, double maxV) = Around(grid.AxisV, row, grid.Size, box.MinV, box.MaxV);
            (double minU, double maxU) = facet.Between(minV - Tolerances.LightPoint, maxV + Tolerances.LightPoint);
            if (!(minU <= maxU))
            {
                continue;
            }

            double ofRow = facet.Wa - rounding + (perV * ((perV > 0.0 ? minV : maxV) - facet.Va));
            int last = Math.Min(bins.LastColumn, grid.AxisU.BinOf(maxU + Tolerances.LightPoint) + 1);
            for (int column = Math.Max(bins.FirstColumn, grid.AxisU.BinOf(minU - Tolerances.LightPoint) - 1); column <= last; column++)
            {
                (double first, double end) = Around(grid.AxisU, column, grid.Size, box.MinU, box.MaxU);
                double nearest = ofRow + (perU * ((perU > 0.0 ? first : end) - facet.Ua));

                // An edge-on facet has no plane over the bins: then the comparison with NaN leaves its nearest corner.
                if (!(Math.Max(minDepth, nearest) >= grid.DepthOf(column, row)))
                {
                    grid.Want(new GridRange(column, column, row, row));
                }
            }
        }
    }

    /// <summary>What a facet has of a bin and its two neighbours along one axis; the outermost bins extend to infinity.</summary>
    private static (double Min, double Max) Around(LightAxis axis, int bin, int size, double min, double max) => (
        bin <= 1 ? min : Math.Max(min, axis.StartOf(bin - 1)), bin >= size - 2 ? max : Math.Min(max, axis.StartOf(bin + 2)));
}
