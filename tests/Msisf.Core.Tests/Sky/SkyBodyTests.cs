using Msisf.Core.Numerics;
using Msisf.Core.Sky;
using Xunit;

namespace Msisf.Core.Tests.Sky;

/// <summary>Planets, the Earth and the Sun: magnitudes against Skyfield, discs and earthshine against sums over spheres.</summary>
public sealed class SkyBodyTests
{
    /// <summary>mag: both sides have the same formulas.</summary>
    private const double SameMagnitude = 1e-6;

    /// <summary>tests/reference/planets.py.</summary>
    [Theory]
    [InlineData(1, 0.31, 1.2, 75.0, 0.0, 0.0, 0.0, -0.38247490019988906)]
    [InlineData(2, 0.72, 0.9, 80.0, 0.0, 0.0, 0.0, -4.124632490647033)]
    [InlineData(2, 0.72, 0.28, 170.0, 0.0, 0.0, 0.0, -4.192241361132584)]
    [InlineData(399, 0.99, 0.0026, 60.0, 0.0, 0.0, 0.0, -16.261117287158157)]
    [InlineData(4, 1.4, 0.7, 30.0, 0.0, 0.0, 0.0, -1.0819496215375262)]
    [InlineData(4, 1.6, 1.3, 65.0, 0.0, 0.0, 0.0, 1.0063791748138082)]
    [InlineData(5, 5.2, 4.3, 7.0, 0.0, 0.0, 0.0, -2.620047003928071)]
    [InlineData(5, 5.2, 4.3, 90.0, 0.0, 0.0, 0.0, -1.2384995887088135)]
    [InlineData(6, 9.5, 8.6, 4.0, -21.0, -18.0, 0.0, 0.1436323432972717)]
    [InlineData(6, 9.5, 8.6, 4.0, 3.0, -1.0, 0.0, 0.7511102826620775)]
    [InlineData(7, 19.2, 18.3, 2.0, 50.0, -52.0, 0.0, 5.5759215921698955)]
    [InlineData(7, 19.2, 18.3, 20.0, 50.0, 52.0, 0.0, 5.7494615921698955)]
    [InlineData(8, 30.0, 29.1, 1.0, 0.0, 0.0, -8.0, 7.750271218527849)]
    [InlineData(8, 30.0, 29.1, 40.0, 0.0, 0.0, 10.0, 8.176703218527848)]
    public void Magnitude_AgreesWithSkyfield(
        int planet, double sun, double distance, double phase, double sunLatitude, double latitude, double years, double expected) =>
        Assert.Equal(expected, PlanetMagnitude.Of(planet, sun, distance, phase, sunLatitude, latitude, years), SameMagnitude);

    /// <summary>Saturn's rings, beyond the phases of which they were measured, go on as they were there.</summary>
    [Fact]
    public void Magnitude_SaturnBeyondItsPhase_IsContinuous() => Assert.Equal(
        PlanetMagnitude.Of(6, 9.5, 9.0, 6.5, 20.0, 20.0, 0.0), PlanetMagnitude.Of(6, 9.5, 9.0, 6.5000001, 20.0, 20.0, 0.0), 1e-6);

    /// <summary>tests/reference/earthshine.py: light on facets of which the Earth lies to the front, from 384 400 km.</summary>
    [Theory]
    [InlineData(5, 1.012351, 0.506642, 0.201942)]
    [InlineData(60, 1.003814, 0.507646, 0.194270)]
    [InlineData(90, 0.990143, 0.503461, 0.188537)]
    [InlineData(140, 0.931481, 0.476783, 0.173803)]
    public void Sphere_OfThePhase_LightsFacetsAsItsPointsDo(double degrees, double front, double turned, double other)
    {
        const double Ratio = 6378136.6 / 3.844e8;
        LambertSphere sphere = LambertSphere.Of(double.DegreesToRadians(degrees), Ratio);
        Vector3D light = sphere.Light * new Vector3D(1.0, Ratio * sphere.Offset, 0.0).Normalized();

        Assert.Equal(front, light.X, 2e-3 * front);
        Assert.Equal(turned, (0.5 * light.X) + (Math.Sqrt(0.75) * light.Y), 2e-3 * turned);
        Assert.Equal(other, (0.2 * light.X) - (Math.Sqrt(0.96) * light.Y), 2e-3 * other);
    }

    /// <summary>All the light of a disc comes from its directions: summed over a fine net of them.</summary>
    [Theory]
    [InlineData("Earth", 0.0)]
    [InlineData("Earth", 1.0)]
    [InlineData("Earth", 2.4)]
    [InlineData("Sun", 0.0)]
    public void Disc_SumOverDirections_IsOne(string name, double phase)
    {
        SkyBody body = name == "Sun" ? SkyBody.Sun : SkyBody.Earth;
        Vector3D centre = new(0.6, 0.0, 0.8);
        Vector3D aside = new(0.48, 0.8, -0.36);
        (double sine, double cosine) = Math.SinCos(phase);
        BodyPlace place = new(body, centre, 60.0 * body.EquatorialRadius, (-cosine * centre) + (sine * aside), phase, 0.0);
        BodyDisc disc = new(place, centre, static vector => vector);
        const int Net = 1200;
        Vector3D u = Vector3D.Cross(centre, Vector3D.UnitY).Normalized();
        Vector3D v = Vector3D.Cross(centre, u);
        const double Half = 1.1 / 60.0;
        double step = 2.0 * Half / Net;
        double sum = 0.0;
        for (int i = 0; i < Net; i++)
        {
            for (int j = 0; j < Net; j++)
            {
                Vector3D way = centre + ((((i + 0.5) * step) - Half) * u) + ((((j + 0.5) * step) - Half) * v);
                sum += disc.LightFrom(way.Normalized()) * step * step / (way.Length * way.LengthSquared);
            }
        }

        Assert.Equal(1.0, sum, 1e-3); // the net at the outline
    }
}
