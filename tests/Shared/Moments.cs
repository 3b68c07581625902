using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.TestSupport;

/// <summary>Moments by the leap seconds of naif0012.tls, typed from its print.</summary>
internal static class Moments
{
    private static readonly (int Year, int Month)[] Steps =
    [
        (1972, 1), (1972, 7), (1973, 1), (1974, 1), (1975, 1), (1976, 1), (1977, 1), (1978, 1), (1979, 1), (1980, 1),
        (1981, 7), (1982, 7), (1983, 7), (1985, 7), (1988, 1), (1990, 1), (1991, 1), (1992, 7), (1993, 7), (1994, 7),
        (1996, 1), (1997, 7), (1999, 1), (2006, 1), (2009, 1), (2012, 7), (2015, 7), (2017, 1),
    ];

    /// <summary>The scale.</summary>
    public static TimeScale Naif0012 { get; } = new(
        new TdbConstants(32.184, 1.657e-3, 1.671e-2, 6.239996, 1.99096871e-7),
        [.. Steps.Select((step, i) => new LeapSecond(
            10.0 + i,
            (new DateTime(step.Year, step.Month, 1) - new DateTime(2000, 1, 1, 12, 0, 0)).TotalSeconds))]);

    /// <summary>The moment of an MJD, UTC.</summary>
    public static Instant OfMjd(double mjd) => Naif0012.InstantOfMjd(mjd);

    /// <summary>A state of its MJD and the numbers behind it.</summary>
    public static SpacecraftState StateOf(ReadOnlySpan<double> numbers) => SpacecraftState.FromNumbers(OfMjd(numbers[0]), numbers[1..]);

    /// <summary>The moment of a kernel's time.</summary>
    public static Instant OfTdb(TdbTime time) => Naif0012.InstantOf(time);
}
