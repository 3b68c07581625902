using Msisf.Core.Errors;
using Msisf.Core.Orbit;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class KeplerElementsTests
{
    [Theory]
    [InlineData(double.NaN, 0.1, 0, 0, 0, 0, "The semi-major axis a (m) is NaN; a finite number is needed.")]
    [InlineData(2e6, double.NaN, 0, 0, 0, 0, "The eccentricity e is NaN; a finite number is needed.")]
    [InlineData(2e6, 0.1, double.NaN, 0, 0, 0, "The argument of periapsis omega (rad) is NaN; a finite number is needed.")]
    [InlineData(
        2e6,
        0.1,
        0,
        double.NegativeInfinity,
        0,
        0,
        "The longitude of the ascending node Omega (rad) is -Infinity; a finite number is needed.")]
    [InlineData(2e6, 0.1, 0, 0, double.PositiveInfinity, 0, "The inclination i (rad) is Infinity; a finite number is needed.")]
    [InlineData(2e6, 0.1, 0, 0, 0, double.NaN, "The mean anomaly at epoch M0 (rad) is NaN; a finite number is needed.")]
    [InlineData(0.0, 0.1, 0, 0, 0, 0, "The semi-major axis a is 0 m; an elliptic orbit needs one above 0 m.")]
    [InlineData(-2000000.5, 0.1, 0, 0, 0, 0, "The semi-major axis a is -2000000.5 m; an elliptic orbit needs one above 0 m.")]
    [InlineData(2e6, -0.1, 0, 0, 0, 0, "The eccentricity e is -0.1; it can't be below 0.")]
    [InlineData(
        2e6, 1.0, 0, 0, 0, 0, "The eccentricity e is 1, a parabola or hyperbola; only elliptic orbits, 0 <= e < 1, can be followed.")]
    [InlineData(
        2e6, 1.5, 0, 0, 0, 0, "The eccentricity e is 1.5, a parabola or hyperbola; only elliptic orbits, 0 <= e < 1, can be followed.")]
    public void Constructor_WrongElement_RefusedByName(
        double a, double e, double omega, double node, double i, double m0, string message) =>
        Assert.Equal(message, Assert.Throws<BadInputException>(() => new KeplerElements(a, e, omega, node, i, m0)).Message);

    [Theory]
    [InlineData(0.0)]
    [InlineData(0.999999999999)]
    public void Constructor_EccentricityAtTheEndsOfItsRange_Taken(double e) =>
        Assert.Equal(e, new KeplerElements(2e6, e, 0.0, 0.0, 0.0, 0.0).Eccentricity);

    [Fact]
    public void PeriapsisRadius_QuarterEccentricity_IsThreeQuartersOfTheAxis() =>
        Assert.Equal(1.8e6, new KeplerElements(2.4e6, 0.25, 1.0, 1.0, 1.0, 1.0).PeriapsisRadius);
}
