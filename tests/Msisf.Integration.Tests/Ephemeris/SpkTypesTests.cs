using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>SPKs of all types that CSPICE itself writes: the built-in reader against CSPICE, in both byte orders.</summary>
[Collection(SpiceItself.Name)]
public sealed class SpkTypesTests : IDisposable
{
    /// <summary>km: as the issue asks for.</summary>
    private const double Position = 1e-9;

    /// <summary>km/s: the positions' 1e-9 km, over tens of seconds between states.</summary>
    private const double Velocity = 5e-11;

    private readonly TemporaryFolder _folder = new();

    public static TheoryData<string> Kinds { get; } = [.. SpkSamples.Kinds];

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.CSpice)]
    [MemberData(nameof(Kinds))]
    public void StateOf_KernelOfCSpicesWriter_IsThatOfCSpice(string kind)
    {
        using OpenedEphemeris loaded = Engines.CSpice(); // the writers ask for the frames
        string little = _folder[$"{kind}.bsp"];
        SpiceItself.WriteSpk(little, handle => SpkSamples.Write(handle, kind));
        string big = _folder.Write($"{kind} big.bsp", BigEndianKernel.Of(File.ReadAllBytes(little)));

        foreach (string path in (string[])[little, big])
        {
            using OpenedEphemeris cspice = Engines.CSpice(Engines.MetaKernel, path);
            using OpenedEphemeris builtIn = Engines.BuiltIn(Engines.MetaKernel, path);
            foreach (double time in Times(kind, path == little ? TestLength.Of(100, 10_000) : 20))
            {
                StateVector expected = cspice.Engine.StateOf(SpkSamples.Body, time);
                StateVector actual = builtIn.Engine.StateOf(SpkSamples.Body, time);
                double units = 1.0 / 1000.0;
                Assert.InRange((actual.Position - expected.Position).Length * units, 0.0, Position);
                Assert.InRange((actual.Velocity - expected.Velocity).Length * units, 0.0, Velocity);
            }
        }
    }

    /// <summary>LRO's own trajectory about the Moon, as NAIF has it and in the other byte order.</summary>
    [RequiresFact(Part.CSpice, Part.LroNac)]
    public void StateOf_KernelOfLro_IsThatOfCSpice()
    {
        string big = _folder.Write("big.bsp", BigEndianKernel.Of(File.ReadAllBytes(LroNac.Spk)));
        Random random = new(27);
        foreach (string path in (string[])[LroNac.Spk, big])
        {
            using OpenedEphemeris cspice = Engines.CSpice(Engines.MetaKernel, path);
            using OpenedEphemeris builtIn = Engines.BuiltIn(Engines.MetaKernel, path);
            builtIn.Catalogue.SpacecraftOf("LRO", out TdbCover cover);
            (double start, double end) = (cover.Intervals[0].Start, cover.Intervals[0].End);
            for (int i = TestLength.Of(100, 10_000); i > 0; i--)
            {
                double time = start + ((end - start) * random.NextDouble());
                StateVector expected = cspice.Engine.StateOf(-85, time);
                StateVector actual = builtIn.Engine.StateOf(-85, time);
                Assert.InRange((actual.Position - expected.Position).Length / 1000.0, 0.0, Position);
                Assert.InRange((actual.Velocity - expected.Velocity).Length / 1000.0, 0.0, Velocity);
            }
        }
    }

    /// <summary>In SPICE the later segment of a file wins, and the later file.</summary>
    [RequiresFact(Part.CSpice)]
    public void StateOf_OverlappingSegments_TakesTheLaterOneAsCSpiceDoes()
    {
        using OpenedEphemeris loaded = Engines.CSpice();
        string both = _folder["both.bsp"];
        SpiceItself.WriteSpk(both, handle =>
        {
            SpkSamples.Write(handle, "9 degree 11");
            SpkSamples.Write(handle, "5 hyperbola");
        });
        string later = _folder["later.bsp"];
        SpiceItself.WriteSpk(later, handle => SpkSamples.Write(handle, "21"));
        List<double> heights = [];
        foreach (string[] kernels in (string[][])[[both], [both, later], [later, both]])
        {
            using OpenedEphemeris cspice = Engines.CSpice([Engines.MetaKernel, .. kernels]);
            using OpenedEphemeris builtIn = Engines.BuiltIn([Engines.MetaKernel, .. kernels]);
            double time = SpkSamples.Epochs("9")[7] + 23.0;
            StateVector actual = builtIn.Engine.StateOf(SpkSamples.Body, time);
            Assert.InRange((actual.Position - cspice.Engine.StateOf(SpkSamples.Body, time).Position).Length, 0.0, 1000.0 * Position);
            heights.Add(actual.Position.Length);
        }

        Assert.Equal(heights[0], heights[2]);
        Assert.InRange(Math.Abs(heights[1] - heights[0]), 0.01, double.MaxValue);
    }

    /// <summary>At random, at the states themselves, and at the ends.</summary>
    private static IEnumerable<double> Times(string kind, int count)
    {
        Random random = new(20090730);
        double[] epochs = SpkSamples.Epochs(kind);
        (double first, double last) = (epochs[0], epochs[^1]);
        return
        [
            first, last, double.BitIncrement(first), double.BitDecrement(last), epochs[1], epochs[^2], double.BitDecrement(epochs[100]),
            epochs[100], double.BitIncrement(epochs[100]),
            .. Enumerable.Range(0, count).Select(_ => first + ((last - first) * random.NextDouble())),
        ];
    }
}
