using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Stores the facets of one cell where they are the nearest ones. A facet is recorded when it first wins a sample.
/// </summary>
internal struct CellWinners
{
    private int _southWest = Band.NotRecorded;
    private int _northEast = Band.NotRecorded;

    /// <summary>For a new cell.</summary>
    public CellWinners()
    {
    }

    /// <summary>The number of one of the cell's facets.</summary>
    /// <param name="index">Index of the cell's north-western vertex in the block.</param>
    /// <param name="half">0: the south-western facet, 1: the north-eastern one.</param>
    public int NumberOf(FacetRecords records, ProjectedBlock block, int index, int half)
    {
        ref int number = ref half == 0 ? ref _southWest : ref _northEast;
        if (number == Band.NotRecorded)
        {
            number = records.Add(block, index, half);
        }

        return number;
    }

    /// <summary>Stores depths and facets of the samples that the cell wins, at least one of eight.</summary>
    /// <param name="index">Index of the cell's north-western vertex in the block.</param>
    /// <param name="inSouthWest">Which of them lie in its south-western facet; the others lie in the north-eastern one.</param>
    /// <param name="facets">The facet of the first sample so far; the other seven follow.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(
        FacetRecords records, ProjectedBlock block, int index, Vector512<double> wins, Vector512<double> inSouthWest, ref int facets)
    {
        Record(records, block, index, (uint)wins.ExtractMostSignificantBits(), (uint)inSouthWest.ExtractMostSignificantBits());
        Store(
            Vector256.ConditionalSelect(Narrow(inSouthWest), Vector256.Create(_southWest), Vector256.Create(_northEast)), wins, ref facets);
    }

    /// <summary>Stores the facets of the samples that the cell wins, at least one of four; the parameters are those of eight.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(
        FacetRecords records, ProjectedBlock block, int index, Vector256<double> wins, Vector256<double> inSouthWest, ref int facets)
    {
        Record(records, block, index, wins.ExtractMostSignificantBits(), inSouthWest.ExtractMostSignificantBits());
        Vector128<int> numbers = Vector128.ConditionalSelect(
            Narrow(inSouthWest), Vector128.Create(_southWest), Vector128.Create(_northEast));
        Vector128.ConditionalSelect(Narrow(wins), numbers, Vector128.LoadUnsafe(ref facets)).StoreUnsafe(ref facets);
    }

    /// <summary>Stores facets where they win.</summary>
    /// <param name="number">The facet of each of eight samples.</param>
    /// <param name="facets">The facet of the first sample so far; the other seven follow.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Vector256<int> number, Vector512<double> wins, ref int facets) =>
        Vector256.ConditionalSelect(Narrow(wins), number, Vector256.LoadUnsafe(ref facets)).StoreUnsafe(ref facets);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Record(FacetRecords records, ProjectedBlock block, int index, uint wins, uint inSouthWest)
    {
        if ((wins & inSouthWest) != 0 && _southWest == Band.NotRecorded)
        {
            _southWest = records.Add(block, index, 0);
        }

        if ((wins & ~inSouthWest) != 0 && _northEast == Band.NotRecorded)
        {
            _northEast = records.Add(block, index, 1);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<int> Narrow(Vector256<double> mask) =>
        Vector128.Narrow(mask.AsInt64().GetLower(), mask.AsInt64().GetUpper());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<int> Narrow(Vector512<double> mask) => Vector512.Narrow(mask.AsInt64(), mask.AsInt64()).GetLower();
}
