using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>Fills one facet, rows of eight pixels at a time.</summary>
internal static class FacetFill
{
    private const int Lanes = 8;

    private static readonly Vector512<double> Steps = Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);

    /// <summary>Draws the facet where it is nearest; records it if that is anywhere.</summary>
    public static void Fill<TEdges>(ref TEdges edges, in FacetPlane plane, PixelRange pixels, in FacetRecord record, Band band)
        where TEdges : struct, IFacetEdges
    {
        Vector512<double> perColumn = Vector512.Create(plane.PerColumn);
        Vector512<double> least = Vector512.Create(plane.Least);
        Vector512<double> greatest = Vector512.Create(plane.Greatest);
        Vector512<double> lastColumn = Vector512.Create((double)pixels.LastColumn);
        Vector256<int> number = default;
        bool isRecorded = false;
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            (double first, double last) = edges.MoveTo(row);
            int begin = (int)Math.Max(pixels.FirstColumn, Math.Ceiling(first));
            int end = (int)Math.Min(pixels.LastColumn, last);
            Vector512<double> atColumn0 = Vector512.Create(plane.Constant + (plane.PerRow * row));
            int start = (row - band.FirstRow) * band.Stride;
            ref double nearest = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(band.InverseParameters), start);
            ref int facets = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(band.Facets), start);
            for (int column = begin; column <= end; column += Lanes)
            {
                Vector512<double> columns = Vector512.Create((double)column) + Steps;
                Vector512<double> parameter = FacetPlanes.Held(atColumn0 + (perColumn * columns), least, greatest);
                Vector512<double> before = Vector512.LoadUnsafe(ref nearest, (nuint)column);
                Vector512<double> wins = Vector512.LessThanOrEqual(edges.Outside(columns), Vector512<double>.Zero)
                    & Vector512.GreaterThan(parameter, before)
                    & Vector512.LessThanOrEqual(columns, lastColumn);
                if (wins == Vector512<double>.Zero)
                {
                    continue;
                }

                if (!isRecorded)
                {
                    number = Vector256.Create(band.Add(record));
                    isRecorded = true;
                }

                Vector512.ConditionalSelect(wins, parameter, before).StoreUnsafe(ref nearest, (nuint)column);
                Vector256<int> mask = Vector512.Narrow(wins.AsInt64(), wins.AsInt64()).GetLower();
                Vector256.ConditionalSelect(mask, number, Vector256.LoadUnsafe(ref facets, (nuint)column)).StoreUnsafe(ref facets, (nuint)column);
            }
        }
    }
}
