using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>CKs of all types that CSPICE itself writes: the built-in reader against CSPICE, in both byte orders, with gaps.</summary>
[Collection(SpiceItself.Name)]
public sealed class CkTypesTests : IDisposable
{
    /// <summary>1: at equal ticks, as the issue asks for.</summary>
    private const double AtTicks = 1e-12;

    /// <summary>1: the rate of the orientations (1e-3 rad/s) over the 1e-7 s to which a time is known, and the above.</summary>
    private const double AtTimes = 1e-10 + AtTicks;

    private readonly TemporaryFolder _folder = new();

    public static TheoryData<string> Kinds { get; } = [.. CkSamples.Kinds];

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.CSpice)]
    [MemberData(nameof(Kinds))]
    public void Attitude_KernelOfCSpicesWriter_IsThatOfCSpice(string kind)
    {
        string sclk = _folder.Write("test.tsc", TestClock.Sclk);
        string frames = _folder.Write("test.tf", TestClock.Frames);
        using OpenedEphemeris loaded = Engines.CSpice(Engines.MetaKernel, sclk, frames); // the writers ask for the clock
        string little = _folder[$"{kind}.bc"];
        SpiceItself.WriteCk(little, handle => CkSamples.Write(handle, kind));
        string big = _folder.Write($"{kind} big.bc", BigEndianKernel.Of(File.ReadAllBytes(little)));
        foreach (string path in (string[])[little, big])
        {
            int count = path == little ? TestLength.Of(100, 10_000) : 20;
            using OpenedEphemeris cspice = Engines.CSpice(Engines.MetaKernel, sclk, frames, path);
            using OpenedEphemeris builtIn = Engines.BuiltIn(Engines.MetaKernel, sclk, frames, path);
            int found = CompareAtTicks(cspice, builtIn, path, count);
            Assert.InRange(found, kind[0] == '1' ? CkSamples.Count : count / 2, int.MaxValue);
            CompareRates(cspice, path, kind);
            if (kind[0] == '1')
            {
                CompareInstants(cspice, builtIn);
            }
            else
            {
                CompareAtTimes(cspice, builtIn, count);
            }
        }
    }

    /// <summary>LRO's own attitudes, of the spacecraft and of its camera on it, as USGS has them and in the other byte order.</summary>
    [RequiresFact(Part.CSpice, Part.LroNac)]
    public void Attitude_KernelsOfLro_IsThatOfCSpice()
    {
        string[] big =
        [
            .. LroNac.Cks.Select((path, i) => _folder.Write($"{i}.bc", BigEndianKernel.Of(File.ReadAllBytes(path)))),
        ];
        int count = TestLength.Of(100, 10_000);
        foreach (string[] cks in (string[][])[[.. LroNac.Cks], big])
        {
            string[] kernels = [Engines.MetaKernel, .. LroNac.TextKernels, .. cks];
            using OpenedEphemeris cspice = Engines.CSpice(kernels);
            using OpenedEphemeris builtIn = Engines.BuiltIn(kernels);
            Assert.NotNull(cspice.Engine.EngineName);
            foreach (string path in cks)
            {
                using DafFile file = DafFile.Open(path);
                CkSegment segment = Assert.Single(DafSegments.OfCk(file));
                string reference = segment.Reference == 1 ? "J2000" : "LRO_SC_BUS";
                Random random = new(28);
                for (int i = 0; i < count; i++)
                {
                    double tick = segment.Ticks.Start + ((segment.Ticks.End - segment.Ticks.Start) * random.NextDouble());
                    RotationMatrix expected = MatrixOf(segment.Instrument, tick, reference)!.Value;
                    AssertClose(expected, segment.At(tick)!.Value.InstrumentFromReference, AtTicks);
                }
            }

            CompareAtTimes(cspice, builtIn, count, -85600, "LRO_LROCNACL");
        }
    }

    /// <summary>How many of the ticks have an attitude.</summary>
    private static int CompareAtTicks(OpenedEphemeris cspice, OpenedEphemeris builtIn, string path, int count)
    {
        Random random = new(7);
        Assert.NotNull(cspice.Engine.EngineName);
        using DafFile file = DafFile.Open(path);
        CkSegment[] segments = [.. DafSegments.OfCk(file)];
        int both = 0;
        double first = CkSamples.Ticks[0] - 1000.0;
        double span = CkSamples.Ticks[^1] + 1000.0 - first;
        foreach (double tick in CkSamples.Ticks.Concat(Enumerable.Range(0, count).Select(_ => first + (span * random.NextDouble()))))
        {
            RotationMatrix? expected = MatrixOf(TestClock.Instrument, tick, "J2000");
            RotationMatrix? matrix = segments.Select(
                segment => segment.At(tick)?.InstrumentFromReference).FirstOrDefault(turn => turn is not null);
            Assert.True(expected is not null == matrix is not null, $"{tick:R}: CSPICE {expected}, built in {matrix}");
            if (matrix is { } actual)
            {
                both++;
                AssertClose(expected!.Value, actual, AtTicks);
            }
        }

        return both;
    }

    /// <summary>Rates that a kernel states are those that CSPICE finds; where it has none, neither has a segment.</summary>
    private static void CompareRates(OpenedEphemeris cspice, string path, string kind)
    {
        Assert.NotNull(cspice.Engine.EngineName);
        using DafFile file = DafFile.Open(path);
        CkSegment segment = Assert.Single(DafSegments.OfCk(file));
        bool hasRates = kind is "1 rates" or "2" or "3 rates" || kind[0] is '5' or '6';
        int compared = 0;
        foreach (double tick in CkSamples.Ticks.SelectMany(tick => (double[])[tick, tick + 123_456.0]))
        {
            double[] rate = new double[3];
            SpiceItself.ckgpav_c(
                TestClock.Instrument, tick, 0.0, SpiceItself.Bytes("J2000"), new double[9], rate, out _, out int isFound);
            SpiceItself.ThrowIfFailed();
            CkAttitude? attitude = segment.At(tick);
            Assert.Equal(isFound == 1, attitude?.Rate is not null);
            if (attitude?.Rate is { } actual)
            {
                compared++;
                Assert.InRange((actual - new Vector3D(rate[0], rate[1], rate[2])).Length, 0.0, AtTicks);
            }
        }

        Assert.Equal(hasRates, compared > CkSamples.Count / 2);
    }

    /// <summary>What a kernel has at instants only is usable at them, by both engines and times to the millisecond.</summary>
    private static void CompareInstants(OpenedEphemeris cspice, OpenedEphemeris builtIn)
    {
        foreach (OpenedEphemeris engine in (OpenedEphemeris[])[cspice, builtIn])
        {
            Assert.NotNull(cspice.Engine.EngineName);
            KernelAttitude attitude = new(engine, "TEST_SC", InstrumentAxes.Parse("+x,+y"));
            Assert.Equal(CkSamples.Count, attitude.Cover.Intervals.Count);
            Assert.All(attitude.Cover.Intervals, interval => Assert.True(interval.IsInstant));
            foreach (int index in (int[])[0, 1, 77, CkSamples.Count - 1])
            {
                double tick = CkSamples.Ticks[index];
                RotationMatrix expected = MatrixOf(TestClock.Instrument, tick, "J2000")!.Value;
                SpiceItself.sct2e_c(TestClock.Clock, tick, out double time);
                foreach (double asked in (double[])[time, time + 4e-4, time - 9e-4])
                {
                    TrajectoryPoint point = new(engine.Engine.TimeScale.InstantOf(asked), asked, default, RotationMatrix.Identity);
                    Vector3D sight = attitude.MoonFromCamera(point) * -Vector3D.UnitX;
                    Assert.InRange((sight - expected.Row2).Length, 0.0, AtTicks);
                    Assert.Equal(builtIn.Catalogue.Frames.RateJ2000("TEST_SC", asked) is null, attitude.RateOf(point) is null);
                }

                TrajectoryPoint between = new(engine.Engine.TimeScale.InstantOf(time + 2.0), time + 2.0, default, RotationMatrix.Identity);
                string message = Assert.Throws<BadInputException>(() => attitude.MoonFromCamera(between)).Message;
                Assert.Contains("is outside what the CKs have of frame TEST_SC: ", message, StringComparison.Ordinal);
                Assert.Contains(" more and ", message, StringComparison.Ordinal);
            }
        }
    }

    private static RotationMatrix? MatrixOf(int instrument, double tick, string reference)
    {
        double[] m = new double[9];
        SpiceItself.ckgp_c(instrument, tick, 0.0, SpiceItself.Bytes(reference), m, out double at, out int isFound);
        SpiceItself.ThrowIfFailed();
        Assert.True(isFound == 0 || at == tick, $"{at:R} in place of {tick:R}");
        return isFound == 0 ? null : new RotationMatrix(new(m[0], m[1], m[2]), new(m[3], m[4], m[5]), new(m[6], m[7], m[8]));
    }

    private static void CompareAtTimes(
        OpenedEphemeris cspice, OpenedEphemeris builtIn, int count, int instrument = TestClock.Instrument, string frame = "TEST_CAMERA")
    {
        // A single orientation holds at one tick, which no time hits.
        foreach (TdbInterval interval in builtIn.Catalogue.Attitudes.CoverOf(instrument).Intervals
            .Where(interval => interval.End > interval.Start))
        {
            Random random = new(11);
            IEnumerable<double> inside = Enumerable.Range(0, count).Select(
                _ => interval.Start + ((interval.End - interval.Start) * random.NextDouble()));
            foreach (double time in inside.Concat([interval.Start, interval.End]))
            {
                AssertClose(cspice.Frames.FrameFromJ2000(frame, time), builtIn.Frames.FrameFromJ2000(frame, time), AtTimes);
            }
        }
    }

    private static void AssertClose(RotationMatrix expected, RotationMatrix actual, double tolerance)
    {
        double error = Math.Max(
            (expected.Row0 - actual.Row0).Length, Math.Max((expected.Row1 - actual.Row1).Length, (expected.Row2 - actual.Row2).Length));
        Assert.InRange(error, 0.0, tolerance);
    }
}
