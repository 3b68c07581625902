using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Clocks of spacecraft against CSPICE.</summary>
[Collection(SpiceItself.Name)]
public sealed class SpacecraftClockTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.CSpice)]
    public void Ticks_ClockOfThreeRates_AreThoseOfCSpice() =>
        Compare(_folder.Write("test.tsc", TestClock.Sclk), TestClock.Clock, 2.995e8, 3.05e8);

    /// <summary>LRO's clock has an entry that leads back by 200 s, on 2009-07-18.</summary>
    [RequiresFact(Part.CSpice, Part.LroNac)]
    public void Ticks_ClockOfLro_AreThoseOfCSpice()
    {
        Compare(LroNac.Clock, -85, 3.005e8, 6.2e8);
        Compare(LroNac.Clock, -85, 3.011e8, 3.0145e8);
    }

    /// <summary>The built-in reader's list of names is a part of CSPICE's.</summary>
    [RequiresFact(Part.CSpice)]
    public void NumberOf_BuiltInNames_IsThatOfCSpice()
    {
        using OpenedEphemeris cspice = Engines.CSpice();
        Assert.NotNull(cspice.Engine.EngineName);
        BodyNames own = new(new KernelPool());
        foreach ((string name, int _) in BodyNames.BuiltIn)
        {
            SpiceItself.bods2c_c(SpiceItself.Bytes(name), out int number, out int isFound);
            Assert.True(isFound != 0, name);
            Assert.Equal(number, own.NumberOf(name.ToLowerInvariant()));
        }
    }

    private static void Compare(string clock, int number, double first, double last)
    {
        using OpenedEphemeris cspice = Engines.CSpice(Engines.MetaKernel, clock);
        KernelPool pool = KernelPool.Of([Path.Combine(TestParts.Kernels, "naif0012.tls"), clock]);
        TimeScale scale = LeapSecondsKernel.ReadScale(pool);
        SpacecraftClock own = SpacecraftClock.Read(pool, number, scale);
        Random random = new(5);
        for (int i = 0; i < TestLength.Of(1000, 100_000); i++)
        {
            double time = first + ((last - first) * random.NextDouble());
            SpiceItself.sce2c_c(number, time, out double ticks);
            SpiceItself.ThrowIfFailed();

            // One step of a time is 6e-8 s, 0.004 ticks of 1/65536 s; of ticks since 2001 it is 0.008.
            Assert.Equal(ticks, own.TicksAt(time), 0.03);
            SpiceItself.sct2e_c(number, ticks, out double back);
            SpiceItself.ThrowIfFailed();
            Assert.Equal(back, own.TimeOf(ticks), 5e-7); // from 2017 on one step is 1.2e-7 s
        }
    }
}
