using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class SpectralBandTests
{
    [Fact]
    public void RadianceOfUnitFactor_AtOneAu_IsIrradianceOverPi()
    {
        // tests/reference/solar_irradiance.py: the mean of ASTM E490-00a from 631.5 to 654.5 nm is 1.620 W m^-2 nm^-1.
        Assert.Equal(0.515662, SpectralBand.Of(643).RadianceOfUnitFactor(149_597_870_700.0), 1e-6);
        Assert.Equal(0.515662 / 4.0, SpectralBand.Of(643).RadianceOfUnitFactor(2.0 * 149_597_870_700.0), 1e-6);
    }

    [Fact]
    public void All_FromVioletToRed_GetBrighter() => Assert.Equal(
        SpectralBand.All.OrderBy(band => band.Nanometres).Select(band => band.Nanometres),
        SpectralBand.All.OrderBy(band => band.Moon.SingleScatteringAlbedo).Select(band => band.Nanometres));

    [Fact]
    public void Of_UnknownBand_IsBadInput() =>
        Assert.Contains("321, 360, 415", Assert.Throws<BadInputException>(() => SpectralBand.Of(500)).Message, StringComparison.Ordinal);
}
