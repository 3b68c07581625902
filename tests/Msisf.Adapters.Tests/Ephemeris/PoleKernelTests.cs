using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public sealed class PoleKernelTests
{
    private const string Pole = "BODY499_POLE_RA = ( 317.2 -0.1 )\nBODY499_POLE_DEC = ( 54.4 )\nBODY499_PM = ( 176.0 350.9 )\n";

    private static readonly CelestialBody Mars = CelestialBody.Of(499);

    [Fact]
    public void Read_AnglesOfDegreeTwo_HaveThreeCoefficientsEach()
    {
        PoleOrientation read = PoleKernel.Read(
            SamplePool.Of(Pole + "BODY499_NUT_PREC_PM = ( 0. 0.1 )\nBODY4_MAX_PHASE_DEGREE = 2\nBODY4_NUT_PREC_ANGLES = ( 1 2 3 4 5 6 )"),
            Mars);

        Assert.Equal([317.2, -0.1], read.RightAscension.Coefficients);
        Assert.Equal([0.0, 0.1], read.Meridian.Amplitudes);
        Assert.Equal([1.0, 2.0, 3.0], read.Angles[0]);
        Assert.Equal([4.0, 5.0, 6.0], read.Angles[1]);
        Assert.Empty(read.Declination.Amplitudes);
    }

    [Theory]
    [InlineData("", "No text kernel gives the orientation of Mars (BODY499_POLE_RA and others), from which IAU_MARS is made.")]
    [InlineData("BODY499_POLE_RA = ( 1 )", "No text kernel assigns BODY499_POLE_DEC")]
    [InlineData("BODY499_POLE_RA = 'x'\nBODY499_POLE_DEC = 1\nBODY499_PM = 1", ": POLE_RA of a body's orientation must be numbers")]
    [InlineData(Pole + "BODY499_NUT_PREC_RA = ( 1 2 )\nBODY4_NUT_PREC_ANGLES = ( 1 2 )", "Mars has 2 periodic terms, but its system has only 1")]
    [InlineData(Pole + "BODY4_NUT_PREC_ANGLES = ( 1 2 3 )", "BODY4_NUT_PREC_ANGLES has 3 numbers; a multiple of 2 is needed")]
    [InlineData(Pole + "BODY499_CONSTANTS_JED_EPOCH = 2433282.5", "BODY499_CONSTANTS_JED_EPOCH is not known to the built-in reader")]
    public void Read_WrongKernel_SaysWhat(string data, string message) => Assert.Contains(
        message, Assert.Throws<BadInputException>(() => PoleKernel.Read(SamplePool.Of(data), Mars)).Message, StringComparison.Ordinal);
}
