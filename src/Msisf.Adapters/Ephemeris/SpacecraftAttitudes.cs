using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using System.Collections.Concurrent;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The CKs among some kernels with the clocks in which they count. Safe for several threads.</summary>
internal sealed class SpacecraftAttitudes
{
    private readonly KernelPool _pool;
    private readonly Lazy<ILookup<int, CkSegment>> _segments;
    private readonly ConcurrentDictionary<int, SpacecraftClock> _clocks = new();

    /// <param name="pool">Has the clocks.</param>
    /// <param name="files">Kernels in load order.</param>
    public SpacecraftAttitudes(KernelPool pool, IReadOnlyList<DafFile> files)
    {
        _pool = pool;

        // In SPICE the last segment of the last kernel is searched first.
        _segments = new Lazy<ILookup<int, CkSegment>>(() => files.Where(file => file.IdWord == "DAF/CK").SelectMany(DafSegments.OfCk)
            .Reverse().ToLookup(segment => segment.Instrument));
    }

    /// <summary>The frame relative to which an instrument is turned; null if no kernel has it.</summary>
    /// <param name="instrument">NAIF's number.</param>
    public int? ReferenceOf(int instrument) => _segments.Value[instrument].FirstOrDefault()?.Reference;

    /// <summary>How an instrument is turned at a time.</summary>
    /// <param name="instrument">NAIF's number; the class ID of its frame.</param>
    /// <param name="frame">Its frame, for messages.</param>
    /// <returns>The attitude, and the reference frame's number.</returns>
    /// <exception cref="BadInputException">No kernel has it, or not at that time.</exception>
    public (CkAttitude Attitude, int Reference) At(int instrument, string frame, TdbTime tdb)
    {
        if (!_segments.Value.Contains(instrument))
        {
            throw new BadInputException(Invariant($"No CK has the attitude of frame {frame} ({instrument}). Add its CK with --ck."));
        }

        SpacecraftClock clock = ClockOf(instrument);
        double ticks = clock.TicksAt(tdb.Seconds);
        double tolerance = Math.Abs(clock.TicksAt(tdb.Seconds + TdbCover.InstantTolerance) - ticks);
        foreach (Func<CkSegment, CkAttitude?> look in
            (Func<CkSegment, CkAttitude?>[])[segment => segment.At(ticks), segment => segment.AtInstant(ticks, tolerance)])
        {
            foreach (CkSegment segment in _segments.Value[instrument])
            {
                if (look(segment) is { } found)
                {
                    return (found, segment.Reference);
                }
            }
        }

        TimeScale scale = LeapSecondsKernel.ReadScale(_pool);
        throw new BadInputException(
            $"{scale.InstantOf(tdb).ToIsoUtc()} is outside what the CKs have of frame {frame}: "
                + $"{new KernelCover(scale, CoverOf(instrument)).Describe()}. Choose a time inside, or other kernels.");
    }

    /// <summary>The times at which the attitude of an instrument is known.</summary>
    /// <param name="instrument">NAIF's number.</param>
    /// <exception cref="BadInputException">The clock is missing, or a kernel is damaged.</exception>
    public TdbCover CoverOf(int instrument) =>
        TdbCover.Union(_segments.Value[instrument].SelectMany(segment => CoverOf(segment).Intervals));

    /// <summary>The times at which a segment has an attitude.</summary>
    /// <exception cref="BadInputException">The clock is missing, or the kernel is damaged.</exception>
    public TdbCover CoverOf(CkSegment segment)
    {
        SpacecraftClock clock = ClockOf(segment.Instrument);
        return TdbCover.Union(
            from ticks in segment.Intervals
            let start = Math.Max(ticks.Start, segment.Ticks.Start)
            let end = Math.Min(ticks.End, segment.Ticks.End)
            where start <= end
            select Inside(clock, start, end));
    }

    /// <summary>Whether the clock in whose ticks an instrument's attitudes count is among the kernels.</summary>
    public bool HasClockOf(int instrument) => SpacecraftClock.IsIn(_pool, NumberOfClock(instrument));

    /// <summary>Turns ticks into TDB. Both are rounded, so the ends are moved inwards by two steps of a double (1.2e-7 s).</summary>
    private static TdbInterval Inside(SpacecraftClock clock, double start, double end)
    {
        (double first, double last) = (clock.TimeOf(start), clock.TimeOf(end));
        (double inner, double outer) = (
            double.BitIncrement(double.BitIncrement(first)), double.BitDecrement(double.BitDecrement(last)));
        return inner < outer ? new TdbInterval(inner, outer) : new TdbInterval(first, Math.Max(first, last));
    }

    private SpacecraftClock ClockOf(int instrument) => _clocks.GetOrAdd(
        instrument, id => SpacecraftClock.Read(_pool, NumberOfClock(id), LeapSecondsKernel.ReadScale(_pool)));

    /// <summary>The clock's number as a frame kernel says it, or as in SPICE that of the spacecraft whose instrument it is.</summary>
    public int NumberOfClock(int instrument)
    {
        string variable = Invariant($"CK_{instrument}_SCLK");
        return _pool.Find(variable) is not null ? _pool.WholeNumber(variable) : instrument / 1000;
    }
}
