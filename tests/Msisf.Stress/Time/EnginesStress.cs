using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Interop;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.Stress.Reference;
using Msisf.TestSupport;

namespace Msisf.Stress.Time;

/// <summary>The built-in kernel reader beside CSPICE.</summary>
public sealed class EnginesStress : IStressTest
{
    private const double Start = 15021.0; // MJD, 1900-01-02
    private const double End = 70171.0; // MJD, 2050-12-31
    private const double SecondsADay = 86400.0;

    /// <inheritdoc/>
    public string Name => "engines";

    /// <inheritdoc/>
    public string Subject =>
        "CSPICE and the built-in reader at random times of 1900 to 2050, next to all leap seconds, and outside the cover: TDB, the errors.";

    /// <inheritdoc/>
    public string? MissingPart => TestParts.CSpiceLibrary is null ? "CSPICE (scripts/get-cspice.sh)" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int times = length == StressLength.Full ? 200_000 : 2_000;
        using BuiltInKernels kernels = ProjectKernels.Open();
        using OpenedEphemeris cspice = ProjectKernels.OpenCSpice();
        _ = cspice.Engine.SunPositionBodyFixed(new ModifiedJulianDate(Start)); // loads the kernels for the calls of deltet_c
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
                found.Errors.ToFigure("times outside with different errors, or none", "", 0.0),
            ],
            []);
    }

    private sealed class Found(BuiltInEphemeris builtIn, IEphemeris cspice)
    {
        private readonly TdbScale _scale = ProjectKernels.ReadScale();

        public WorstCase Tdb { get; } = new();

        public CaseCount Errors { get; } = new();

        public void NoteInside(ModifiedJulianDate time)
        {
            double utcSeconds = (SecondsADay * (time.DayNumber - 51544.5)) + time.SecondsOfDay;
            CSpiceNative.deltet_c(utcSeconds, "UTC", out double deltaSeconds);
            double tdbSeconds = utcSeconds + deltaSeconds;
            Tdb.Note(Math.Abs(_scale.FromUtc(time) - tdbSeconds) / Ulp.Of(tdbSeconds), () => MjdText.Of(time.Days));
        }

        public void NoteOutside(ModifiedJulianDate time)
        {
            string? builtInError = Refusals.Of(() => builtIn.SunPositionBodyFixed(time));
            string? cspiceError = Refusals.Of(() => cspice.SunPositionBodyFixed(time));
            Errors.Note(builtInError is null || builtInError != cspiceError, () => MjdText.Of(time.Days));
        }
    }
}
