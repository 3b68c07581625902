using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.Stress.Time;
using Msisf.TestSupport;

namespace Msisf.Stress.Engines;

/// <summary>The built-in kernel reader against CSPICE, with the same kernels.</summary>
public sealed class EphemerisStress : IStressTest
{
    /// <summary>1: the project's plan. TDB's last place alone is worth 1.3e-12 before 1932, so both must round it alike.</summary>
    private const double Agreement = 1e-12;

    private const int Bins = 30;

    /// <inheritdoc/>
    public string Name => "ephemeris-engines";

    /// <inheritdoc/>
    public string Subject =>
        "The two ephemeris engines, CSPICE and the built-in reader: the Sun without and with light time and aberration, "
            + "and the Moon's frame, over the whole cover of the shipped kernels; "
            + "half of the times within 10 s of leap seconds, borders of records and the cover's ends.";

    /// <inheritdoc/>
    public string? MissingPart => TestParts.CSpiceLibrary is null ? "CSPICE (scripts/get-cspice.sh)" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 500_000 : 10_000;
        using OpenedEphemeris cspice = ProjectKernels.OpenCSpice();
        using BuiltInKernels builtIn = ProjectKernels.Open();
        EphemerisTimes times = new(builtIn.Ephemeris.Cover);
        Aberration[] aberrations = Enum.GetValues<Aberration>();
        WorstCase[] suns = [.. aberrations.Select(_ => new WorstCase())];
        WorstCase frame = new();
        SeriesBuilder overYears = new(times.First, times.Last, Bins, isLogarithmic: false);
        CaseRandom random = new(seed, part: 0);
        for (int i = 0; i < cases; i++)
        {
            Instant time = times.Draw(random);
            string Input() => MjdText.Of(time.Mjd);
            for (int k = 0; k < suns.Length; k++)
            {
                double error = SunDifference(cspice.Engine, builtIn.Ephemeris, time, aberrations[k]);
                suns[k].Note(error, Input);
                overYears.Add(time.Mjd, error);
            }

            frame.Note(FrameDifference(cspice.Engine, builtIn.Ephemeris, time), Input);
        }

        return new StressReport(
            Name,
            cases,
            [
                .. aberrations.Select((aberration, k) => suns[k].ToFigure(
                    $"the Sun with --aberration {OptionOf(aberration)}, difference in parts of its distance", "1", Agreement)),
                frame.ToFigure("MOON_ME from J2000, greatest difference of a row", "1", Agreement),
            ],
            [overYears.ToSeries("difference of the Sun's position", "parts of its distance", "time", "MJD", Agreement)]);
    }

    private static string OptionOf(Aberration aberration) => aberration switch
    {
        Aberration.None => "none",
        Aberration.LightTime => "lt",
        _ => "lt+s",
    };

    private static double SunDifference(IEphemeris cspice, BuiltInEphemeris builtIn, Instant time, Aberration aberration)
    {
        Vector3D sun = cspice.SunPositionBodyFixed(time, aberration);
        return (builtIn.SunPositionBodyFixed(time, aberration) - sun).Length / sun.Length;
    }

    private static double FrameDifference(IEphemeris cspice, BuiltInEphemeris builtIn, Instant time)
    {
        RotationMatrix expected = cspice.BodyFromJ2000(time.Tdb);
        RotationMatrix found = builtIn.BodyFromJ2000(time.Tdb);
        return Math.Max(
            (found.Row0 - expected.Row0).Length,
            Math.Max((found.Row1 - expected.Row1).Length, (found.Row2 - expected.Row2).Length));
    }
}
