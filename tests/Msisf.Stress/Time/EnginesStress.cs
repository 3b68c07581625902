using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Interop;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.Stress.Numerics;
using Msisf.TestSupport;

namespace Msisf.Stress.Time;

/// <summary>The built-in kernel reader beside CSPICE.</summary>
public sealed class EnginesStress : IStressTest
{
    /// <summary>1, of the distance, and of a matrix's element: half a unit of TDB in 1900 turns the Sun by 7e-13.</summary>
    private const double Position = 1e-12;

    private const double Start = 15021.0; // MJD, 1900-01-02
    private const double End = 70171.0; // MJD, 2050-12-31
    private const double SecondsADay = 86400.0;

    /// <inheritdoc/>
    public string Name => "engines";

    /// <inheritdoc/>
    public string Subject =>
        "CSPICE and the built-in reader at random times of 1900 to 2050, next to all leap seconds, and outside the cover: TDB, the Sun, the Moon's axes, the errors.";

    /// <inheritdoc/>
    public string? MissingPart => TestParts.CSpiceLibrary is null ? "CSPICE (scripts/get-cspice.sh)" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int times = length == StressLength.Full ? 200_000 : 2_000;
        using BuiltInKernels kernels = ProjectKernels.Open();
        using OpenedEphemeris cspice = ProjectKernels.OpenCSpice();
        Found found = new(kernels.Ephemeris, cspice.Engine);
        CaseRandom random = new(seed, part: 0);
        double[] leapSeconds = [.. StressTable.Rows("leap_seconds.csv").Select(row => row[0])];
        foreach (double mjd in leapSeconds.Concat(Enumerable.Range(0, times).Select(_ => random.Between(Start, End))))
        {
            found.NoteInside(new ModifiedJulianDate(mjd));
        }

        int outside = times / 100; // CSPICE's error needs all kernels read anew
        for (int count = 0; count < outside; count++)
        {
            double away = random.Logarithmic(1.0, 6e5);
            found.NoteOutside(new ModifiedJulianDate(random.Below(2) == 0 ? Start - 2.0 - away : End + 2.0 + away));
        }

        return new StressReport(
            Name,
            times + leapSeconds.Length + outside,
            [
                found.Tdb.ToFigure("TDB", "ulp", 0.0),
                found.Sun.ToFigure("the Sun's position, of its distance", "", Position),
                found.Axes.ToFigure("an element of the rotation from J2000 to MOON_ME", "", Position),
                found.Errors.ToFigure("times outside with different errors, or none", "", 0.0),
            ],
            [found.OverDate.ToSeries("the Sun's position", "of its distance", "MJD", "", Position)]);
    }

    private sealed class Found(BuiltInEphemeris builtIn, IEphemeris cspice)
    {
        private readonly TdbScale _scale = ProjectKernels.ReadScale();

        public WorstCase Tdb { get; } = new();

        public WorstCase Sun { get; } = new();

        public WorstCase Axes { get; } = new();

        public CaseCount Errors { get; } = new();

        public SeriesBuilder OverDate { get; } = new(Start, End, 50, isLogarithmic: false);

        public void NoteInside(ModifiedJulianDate time)
        {
            Vector3D right = cspice.SunPositionMoonMe(time);
            double sun = (builtIn.SunPositionMoonMe(time) - right).Length / right.Length;
            Note(Sun, sun, time);
            OverDate.Add(time.Days, sun);

            RotationMatrix found = builtIn.MoonMeFromJ2000(time);
            RotationMatrix axes = cspice.MoonMeFromJ2000(time);
            Note(Axes, new[] { found.Row0 - axes.Row0, found.Row1 - axes.Row1, found.Row2 - axes.Row2 }.Select(Largest).Aggregate(Math.Max), time);

            // The kernels of the question above are still the loaded ones.
            double utcSeconds = (SecondsADay * (time.DayNumber - 51544.5)) + time.SecondsOfDay;
            CSpiceNative.deltet_c(utcSeconds, "UTC", out double deltaSeconds);
            double tdbSeconds = utcSeconds + deltaSeconds;
            Note(Tdb, Math.Abs(_scale.FromUtc(time) - tdbSeconds) / Ulp.Of(tdbSeconds), time);
        }

        public void NoteOutside(ModifiedJulianDate time)
        {
            string? builtInError = Refusals.Of(() => builtIn.SunPositionMoonMe(time));
            string? cspiceError = Refusals.Of(() => cspice.SunPositionMoonMe(time));
            Errors.Add(builtInError is null || builtInError != cspiceError, () => FormattableString.Invariant($"MJD {time.Days:R}"));
        }

        private static double Largest(Vector3D v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));

        private static void Note(WorstCase worst, double error, ModifiedJulianDate time)
        {
            if (worst.IsBeatenBy(error))
            {
                worst.Take(error, FormattableString.Invariant($"MJD {time.Days:R}"));
            }
        }
    }
}
