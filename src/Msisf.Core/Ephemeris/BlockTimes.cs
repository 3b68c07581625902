using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The blocks of a file that hold at different times, and what is said where none holds.</summary>
/// <param name="blocks">When each block holds, in the order of the file; where two do, the later one is used, as in SPICE.</param>
/// <param name="source">The file's name, for messages.</param>
/// <param name="scale">Turns TDB into UTC, for messages.</param>
public sealed class BlockTimes(IReadOnlyList<TdbInterval> blocks, string source, TimeScale scale)
{
    /// <summary>s: an end that was printed as an MJD comes back up to 0.6 microseconds after it.</summary>
    private const double Rounding = 2e-6;

    private static readonly Duration Millisecond = Duration.OfSeconds(0.001m);

    /// <summary>The times at which a block holds.</summary>
    public TdbCover Cover { get; } = TdbCover.Union(blocks);

    /// <summary>The block to use at a time.</summary>
    /// <returns>Its place in the file, from 0.</returns>
    /// <exception cref="BadInputException">The time is in no block.</exception>
    public int Find(TdbTime time)
    {
        int widened = -1;
        for (int i = blocks.Count - 1; i >= 0; i--)
        {
            if (blocks[i].Contains(time))
            {
                return i;
            }

            if (time.Seconds >= blocks[i].Start - Rounding && time.Seconds <= blocks[i].End + Rounding)
            {
                widened = i;
            }
        }

        return widened >= 0 ? widened : throw Outside(time);
    }

    private BadInputException Outside(TdbTime time)
    {
        string asked = Invariant($"{source}: {Text(time)} (MJD {scale.InstantOf(time).Mjd:R}) is");
        IReadOnlyList<TdbInterval> covered = Cover.Intervals;
        int after = Enumerable.Range(0, covered.Count).FirstOrDefault(i => covered[i].Start > time.Seconds, covered.Count);
        return after > 0 && after < covered.Count
            ? new BadInputException(
                $"{asked} between two blocks, of which one ends at {Text(covered[after - 1].End)} and the next begins at "
                    + $"{Text(covered[after].Start)}; nothing is known between them. Choose a time inside a block.")
            : new BadInputException(
                $"{asked} outside the file, which has {Text(covered[0].Start)} to {Text(covered[^1].End)}"
                    + $"{(covered.Count > 1 ? $" in {covered.Count} blocks" : string.Empty)}. Choose a time inside.");
    }

    /// <summary>UTC to the millisecond.</summary>
    private string Text(TdbTime time) => $"{scale.InstantOf(time).Utc.RoundedTo(Millisecond)}Z";
}
