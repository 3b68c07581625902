using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Random moments in all time systems, beside CSPICE and Astropy.</summary>
[Collection(SpiceItself.Name)]
public sealed class TimeScaleTests : IDisposable
{
    private const int Moments = 10_000;
    private const int FirstDay = -94_553; // 1600-01-01
    private const int EndDay = 197_642; // 2400-01-01
    private const int DayOfLeapSeconds = 41_317; // 1972-01-01

    /// <summary>Some days that end with a leap second, MJD: of 1972, 1998, 2005, 2008, 2012, 2015 and 2016.</summary>
    private static readonly int[] LeapDays = [41_498, 51_178, 53_735, 54_831, 56_108, 57_203, 57_753];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Moments are multiples of 1/1024 s, which a double of seconds holds, so that only CSPICE's own sums round.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData(TimeSystem.Utc)]
    [InlineData(TimeSystem.Tai)]
    [InlineData(TimeSystem.Tt)]
    [InlineData(TimeSystem.Tdb)]
    [InlineData(TimeSystem.Gps)]
    public void InstantOf_RandomMoments_AreThoseOfCSpice(TimeSystem system)
    {
        using OpenedEphemeris loaded = Engines.CSpice();
        TimeScale scale = loaded.Engine.TimeScale;
        _ = loaded.Engine.BodyFromJ2000(0.0); // loads the kernels
        Random random = new(43 + (int)system);
        for (int i = 0; i < Moments; i++)
        {
            CalendarTime time = new(
                random.Next(FirstDay, EndDay), Duration.OfSeconds(random.Next(86_400)) + Duration.OfSeconds(random.Next(1024) / 1024.0));

            double expected = OfCSpice(time, system);

            double step = Math.BitIncrement(Math.Abs(expected)) - Math.Abs(expected);
            Assert.InRange(Math.Abs(scale.InstantOf(time, system).Tdb.Seconds - expected), 0.0, step);
        }

        SpiceItself.ThrowIfFailed();
    }

    /// <summary>TAI, TT and GPS of UTC, and UTC itself, to the nanosecond that is printed; a part of them in leap seconds.</summary>
    [RequiresFact(Part.Astropy)]
    public void CalendarOf_RandomMoments_AreThoseOfAstropy()
    {
        TimeScale scale = LeapSecondsKernel.ReadScale([Path.Combine(TestParts.Kernels, "naif0012.tls")]);
        Random random = new(7);
        List<string> lines = [];
        for (int i = 0; i < Moments; i++)
        {
            Duration fraction = Duration.OfSeconds(random.Next(1_000_000_000) * 1e-9m);
            CalendarTime time = new(random.Next(DayOfLeapSeconds, EndDay), fraction + Duration.OfSeconds(random.Next(86_400)));
            if (i % 20 == 0)
            {
                CalendarTime leap = CalendarTime.InLeapSecond(LeapDays[random.Next(LeapDays.Length)], fraction);
                Assert.True(scale.HasMoment(leap, TimeSystem.Utc));
                time = leap;
            }

            Instant moment = scale.InstantOf(time);
            lines.Add(string.Join(' ', Enum.GetValues<TimeSystem>().Select(system => scale.CalendarOf(moment, system).ToNanoseconds())));
        }

        File.WriteAllLines(_folder["moments.txt"], lines);
        string output = ChildRun.Of(
            TestParts.Python!,
            ["-B", Path.Combine(TestParts.RepositoryRoot, "tests", "reference", "moments.py"), _folder["moments.txt"]],
            _folder.Path).Succeeded().Output;

        foreach (string word in output.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries))
        {
            Assert.InRange(double.Parse(word, CultureInfo.InvariantCulture), 0.0, 1e-9);
        }
    }

    /// <summary>Moments that a double of ephemeris seconds holds, so that both engines are asked for the very same ones.</summary>
    [RequiresFact(Part.CSpice, Part.LroNac)]
    public void StateOf_MomentsThatADoubleHolds_IsThatOfCSpice()
    {
        using OpenedEphemeris cspice = Engines.CSpice(Engines.MetaKernel, LroNac.Spk);
        using OpenedEphemeris builtIn = Engines.BuiltIn(Engines.MetaKernel, LroNac.Spk);
        _ = cspice.Engine.BodyFromJ2000(0.0); // loads the kernels
        builtIn.Catalogue.SpacecraftOf("LRO", out TdbCover cover);
        TdbInterval ofLro = cover.Intervals[0];
        TdbInterval ofPlanets = new(-3e9, 1.6e9);
        Random random = new(11);
        (int Body, TdbInterval When, double Metres)[] bodies =
            [(-85, ofLro, 1e-6), (10, ofPlanets, 1e-4), (399, ofPlanets, 1e-4), (4, ofPlanets, 1e-4), (5, ofPlanets, 1e-4)];
        foreach ((int body, TdbInterval when, double metres) in bodies)
        {
            for (int i = 0; i < 200; i++)
            {
                double seconds = Math.Ceiling(1024.0 * (when.Start + (random.NextDouble() * (when.End - when.Start - 0.01)))) / 1024.0;
                TimeScale scale = builtIn.Engine.TimeScale;
                CalendarTime utc = scale.InstantOf(seconds).Utc;
                double[] km = new double[6];
                SpiceItself.spkgeo_c(body, seconds, SpiceItself.Bytes("J2000"), 301, km, out _);

                Instant moment = scale.InstantOf(utc);
                Vector3D found = builtIn.Engine.StateOf(body, moment.Tdb).Position;

                Assert.Equal(seconds, moment.Tdb.Seconds);
                Assert.InRange((found - (1000.0 * new Vector3D(km[0], km[1], km[2]))).Length, 0.0, metres);
                Assert.InRange((cspice.Engine.StateOf(body, moment.Tdb).Position - found).Length, 0.0, metres);
            }
        }

        SpiceItself.ThrowIfFailed();
    }

    private static double OfCSpice(CalendarTime time, TimeSystem system)
    {
        if (system is TimeSystem.Tai or TimeSystem.Gps)
        {
            double tai = (time - CalendarTime.OfMjd(51544.5)).TotalSeconds + (system == TimeSystem.Gps ? 19.0 : 0.0);
            return SpiceItself.unitim_c(tai, SpiceItself.Bytes("TAI"), SpiceItself.Bytes("ET"));
        }

        string name = system switch { TimeSystem.Utc => "UTC", TimeSystem.Tt => "TDT", _ => "TDB" };
        SpiceItself.str2et_c(SpiceItself.Bytes($"{time.ToExactText().Replace('T', ' ')} {name}"), out double seconds);
        return seconds;
    }
}
