using System.Numerics;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Tests one facet against eight receivers at a time; used for facets that are larger than pixels.</summary>
internal static class FacetCaster
{
    /// <summary>Hides the receivers behind a facet that faces away from the Sun.</summary>
    /// <param name="hidden">One value for each pixel, row by row; set to 1 where the facet hides the Sun.</param>
    /// <returns>Number of vectors of eight receivers that were tested.</returns>
    public static int Cast(in LightFacet facet, SortedReceivers grid, byte[] hidden)
    {
        LightBox box = facet.Box;
        GridRange bins = grid.Bins.BinsOf(in box);
        if (!(facet.MinDepth < grid.Bins.Max(bins)))
        {
            return 0;
        }

        int tries = 0;
        for (int row = bins.FirstRow; row <= bins.LastRow; row++)
        {
            // The first and the last row also hold the receivers beyond the grid, so there the facet is cut on one side only.
            (double min, double max) = facet.Between(
                row == bins.FirstRow ? double.NegativeInfinity : grid.Bins.AxisV.StartOf(row) - Tolerances.LightPoint,
                row == bins.LastRow ? double.PositiveInfinity : grid.Bins.AxisV.StartOf(row + 1) + Tolerances.LightPoint);
            (int first, int end) = grid.Run(
                row,
                Math.Max(bins.FirstColumn, grid.Bins.AxisU.BinOf(min - Tolerances.LightPoint)),
                Math.Min(bins.LastColumn, grid.Bins.AxisU.BinOf(max + Tolerances.LightPoint)));
            if (end > first)
            {
                Hide(in facet, grid, first, end, hidden);
                tries += (end - first + Vector512<double>.Count - 1) / Vector512<double>.Count;
            }
        }

        return tries;
    }

    /// <summary>Marks the hidden receivers of a range with the sums of <see cref="CellStrip.IsInFrontOf"/>, in the same order.</summary>
    private static void Hide(in LightFacet facet, SortedReceivers grid, int first, int end, byte[] hidden)
    {
        ReadOnlySpan<double> us = grid.U;
        ReadOnlySpan<double> vs = grid.V;
        ReadOnlySpan<double> ws = grid.W;
        for (int i = first; i < end; i += Vector512<double>.Count)
        {
            Vector512<double> u = ArrayLanes.Load(us, i);
            Vector512<double> v = ArrayLanes.Load(vs, i);
            Vector512<double> ua = Vector512.Create(facet.Ua) - u;
            Vector512<double> va = Vector512.Create(facet.Va) - v;
            Vector512<double> ub = Vector512.Create(facet.Ub) - u;
            Vector512<double> vb = Vector512.Create(facet.Vb) - v;
            Vector512<double> uc = Vector512.Create(facet.Uc) - u;
            Vector512<double> vc = Vector512.Create(facet.Vc) - v;
            Vector512<double> weightA = CellEdges.Cross(ub, vb, uc, vc);
            Vector512<double> weightB = CellEdges.Cross(uc, vc, ua, va);
            Vector512<double> weightC = CellEdges.Cross(ua, va, ub, vb);
            Vector512<double> isInside = Vector512.GreaterThanOrEqual(
                Vector512.MinNative(weightA, Vector512.MinNative(weightB, weightC)), Vector512<double>.Zero);
            if (isInside == Vector512<double>.Zero)
            {
                continue;
            }

            Vector512<double> w = ArrayLanes.Load(ws, i);
            Vector512<double> deeper = (weightA * (Vector512.Create(facet.Wa) - w))
                + (weightB * (Vector512.Create(facet.Wb) - w))
                + (weightC * (Vector512.Create(facet.Wc) - w));
            uint isHidden = (uint)(isInside & Vector512.LessThan(deeper, Vector512<double>.Zero)).ExtractMostSignificantBits();
            for (isHidden &= SortedReceivers.Meant(i, end); isHidden != 0; isHidden &= isHidden - 1)
            {
                hidden[grid.Pixels[i + BitOperations.TrailingZeroCount(isHidden)]] = 1;
            }
        }
    }
}
