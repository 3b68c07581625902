using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
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
            Assert.InRange(found, kind == "1" ? CkSamples.Count : count / 2, int.MaxValue);
            if (kind != "1")
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
                    AssertClose(expected, segment.InstrumentFromReference(tick)!.Value, AtTicks);
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
                segment => segment.InstrumentFromReference(tick)).FirstOrDefault(turn => turn is not null);
            Assert.True(expected is not null == matrix is not null, $"{tick:R}: CSPICE {expected}, built in {matrix}");
            if (matrix is { } actual)
            {
                both++;
                AssertClose(expected!.Value, actual, AtTicks);
            }
        }

        return both;
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
