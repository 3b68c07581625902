using Msisf.Core.Detector;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class SpectralResponseTests
{
    private const double Relative = 1e-12; // rounding of some hundred terms

    /// <summary>
    /// Linear efficiency 0.2 to 0.6 between 400 and 600 nm, transmission 0.9, E = 2 W m^-2 nm^-1: the integral of 0.9 x 2 x QE(l) l dl is
    /// 1.8 (0.4 x 500 x 200 + 0.002 x 200^3 / 12) = 74 400 nm^2; times 1e-9 / (h c), by hand.
    /// </summary>
    [Fact]
    public void ElectronRate_LinearEfficiency_IsTheIntegral()
    {
        SpectralResponse band = new(400.0, 600.0, new SpectralCurve(0.9), new SpectralCurve([(400.0, 0.2), (600.0, 0.6)]));
        double expected = 74_400.0 * 1e-9 / (6.62607015e-34 * 299792458.0);
        double found = band.ElectronRate(_ => 2.0);
        Assert.InRange(found, expected * (1.0 - Relative), expected * (1.0 + Relative));
    }

    [Fact]
    public void ElectronRate_TableNarrowerThanTheBand_CountsTheTableOnly()
    {
        SpectralResponse wide = new(300.0, 900.0, new SpectralCurve(1.0), new SpectralCurve([(500.0, 0.5), (510.0, 0.5)]));
        SpectralResponse narrow = new(500.0, 510.0, new SpectralCurve(1.0), new SpectralCurve(0.5));
        Assert.InRange(wide.ElectronRate(_ => 1.0) / narrow.ElectronRate(_ => 1.0), 1.0 - Relative, 1.0 + Relative);
    }
}
