using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>The Sun from bodies with a frame of a text kernel.</summary>
public sealed class OtherBodyTests
{
    /// <summary>1: as of the Moon (EngineAgreementTests); the prime meridian of Mercury has turned by 1e3 rad since 2000.</summary>
    private const double Agreement = 2e-12;

    private static readonly CelestialBody Mercury = CelestialBody.Of(199);

    /// <summary>tests/reference/mercury_sun.py: mpmath on de421.bsp, with the IAU's published elements.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData(EphemerisChoice.CSpice, "2010-04-06T20:24:00Z", 49089192817.943634, -393227180.20315812, 28696140.614195732)]
    [InlineData(EphemerisChoice.BuiltIn, "2010-04-06T20:24:00Z", 49089192817.943634, -393227180.20315812, 28696140.614195732)]
    [InlineData(EphemerisChoice.CSpice, "2020-11-23T06:00:00Z", 56037155921.851873, -20279806732.689153, 12692791.032227551)]
    [InlineData(EphemerisChoice.BuiltIn, "2020-11-23T06:00:00Z", 56037155921.851873, -20279806732.689153, 12692791.032227551)]
    public void SunPosition_Mercury_IsTheIndependentOne(EphemerisChoice choice, string time, double x, double y, double z)
    {
        using OpenedEphemeris ephemeris = Open(choice, Mercury, Bodies);
        Vector3D expected = new(x, y, z);

        Vector3D found = ephemeris.Engine.SunPositionBodyFixed(ephemeris.Engine.TimeScale.InstantOf(TimeText.Parse(time)));

        Assert.Equal(0.0, (found - expected).Length / expected.Length, Agreement);
    }

    [RequiresTheory(Part.CSpice)]
    [InlineData(Aberration.None)]
    [InlineData(Aberration.LightTime)]
    [InlineData(Aberration.LightTimeAndStellar)]
    public void SunPosition_BothEngines_Agree(Aberration aberration)
    {
        using OpenedEphemeris cspice = Open(EphemerisChoice.CSpice, Mercury, Bodies);
        using OpenedEphemeris builtIn = Open(EphemerisChoice.BuiltIn, Mercury, Bodies);
        for (double mjd = 48000.0; mjd < 66000.0; mjd += 333.3)
        {
            Vector3D expected = cspice.Engine.SunPositionBodyFixed(Moments.OfMjd(mjd), aberration);
            Vector3D found = builtIn.Engine.SunPositionBodyFixed(Moments.OfMjd(mjd), aberration);
            Assert.Equal(0.0, (found - expected).Length / expected.Length, Agreement);
            RotationMatrix turned = cspice.Engine.BodyFromJ2000(Moments.OfMjd(mjd).Tdb);
            Assert.Equal(0.0, (turned.Row0 - builtIn.Engine.BodyFromJ2000(Moments.OfMjd(mjd).Tdb).Row0).Length, Agreement);
            Vector3D rate = cspice.Engine.BodyRateJ2000(Moments.OfMjd(mjd).Tdb);
            Assert.Equal(0.0, (rate - builtIn.Engine.BodyRateJ2000(Moments.OfMjd(mjd).Tdb)).Length / rate.Length, Agreement);
        }
    }

    /// <summary>The Moon's kernels have no text kernel of Mercury, those of other bodies none of Mars.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData(EphemerisChoice.CSpice)]
    [InlineData(EphemerisChoice.BuiltIn)]
    public void Open_WithoutTextKernel_SaysWhatIsMissing(EphemerisChoice choice)
    {
        string message = Assert.Throws<BadInputException>(() => Open(choice, Mercury, Engines.MetaKernel)).Message;
        Assert.StartsWith("No text kernel gives the orientation of Mercury (BODY199_POLE_RA", message, StringComparison.Ordinal);
        Assert.Contains("--kernels", message, StringComparison.Ordinal);
        Assert.Contains(
            "orientation of Mars",
            Assert.Throws<BadInputException>(() => Open(choice, CelestialBody.Of(499), Bodies)).Message,
            StringComparison.Ordinal);
    }

    /// <summary>DE421 ends in 2053.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData(EphemerisChoice.CSpice)]
    [InlineData(EphemerisChoice.BuiltIn)]
    public void SunPosition_AfterTheKernels_NamesTheCover(EphemerisChoice choice)
    {
        using OpenedEphemeris ephemeris = Open(choice, Mercury, Bodies);

        string message = Assert.Throws<SpiceException>(
            () => ephemeris.Engine.SunPositionBodyFixed(Moments.OfMjd(90000.0))).Message;

        Assert.Contains("is outside the kernels' cover: the kernels cover 1899-07-28", message, StringComparison.Ordinal);
    }

    private static string Bodies => Path.Combine(TestParts.Kernels, "bodies.tm");

    private static OpenedEphemeris Open(EphemerisChoice choice, CelestialBody body, string kernels) => EphemerisFactory.Open(
        new EphemerisRequest(choice, [kernels], TestParts.RepositoryRoot, TestParts.CSpiceLibrary) { Body = body });
}
