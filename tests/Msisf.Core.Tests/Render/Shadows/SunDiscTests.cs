using System.Numerics;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

public sealed class SunDiscTests
{
    private static readonly Vector3D Sun = new(1.2e11, -0.9e11, 4e9);

    [Fact]
    public void Points_Any_LieAcrossTheLineToTheSunWithinItsAngularRadius()
    {
        SunDisc disc = new(Sun);
        Vector3D axis = Sun.Normalized();
        double angularRadius = Math.Atan2(695_700e3, Math.Sqrt(Sun.LengthSquared - (695_700e3 * 695_700e3))); // asin(R / D)
        Assert.Equal(Math.Tan(angularRadius), disc.Slope, Rounding.OfUnits);
        Assert.Equal(0.2655, angularRadius * 180.0 / Math.PI, 5e-4); // 16 minutes of arc at 1.003 au
        foreach (Vector3D point in disc.PointsBodyFixed)
        {
            Assert.Equal(0.0, Vector3D.Dot(axis, point - Sun), 1e-3);
            Assert.InRange(Vector3D.AngleBetween(point, Sun), 0.1 * angularRadius, angularRadius);
        }

        Vector3D mean = disc.PointsBodyFixed.ToArray().Aggregate((a, b) => a + b) / SunDisc.Points;
        Assert.True((mean - Sun).Length < 1e-3);
    }

    /// <summary>The disc's segment beyond a straight edge, in closed form: (acos d - d sqrt(1 - d^2)) / pi.</summary>
    [Fact]
    public void Points_BesideAStraightEdge_GiveTheSegmentsArea()
    {
        SunDisc disc = new(Sun);
        LightFrame axes = new(Sun, Vector3D.UnitY);
        double worst = 0.0;
        double squares = 0.0;
        for (int angle = 0; angle < 360; angle++)
        {
            (double sine, double cosine) = Math.SinCos(angle * Math.PI / 180.0);
            Vector3D across = (cosine * axes.AxisU) + (sine * axes.AxisV);
            for (int step = -100; step <= 100; step++)
            {
                double edge = step / 100.0;
                double area = (Math.Atan2(Math.Sqrt(1.0 - (edge * edge)), edge) - (edge * Math.Sqrt(1.0 - (edge * edge)))) / Math.PI;
                int beyond = 0;
                foreach (Vector3D point in disc.PointsBodyFixed)
                {
                    beyond += Vector3D.Dot(point - Sun, across) > edge * disc.Slope * Sun.Length ? 1 : 0;
                }

                double error = Math.Abs(area - ((double)beyond / SunDisc.Points));
                worst = Math.Max(worst, error);
                squares += error * error;
            }
        }

        // tests/reference/sun_disc.py
        Assert.InRange(worst, 0.03, 0.046);
        Assert.InRange(Math.Sqrt(squares / (360 * 201)), 0.01, 0.012);
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.3)]
    public void LightAt_WholeDiscAboveTheFacet_IsNearlyThatOfItsCentre(double height)
    {
        SunDisc disc = new(Sun);
        (Vector3D point, Vector3D normal) = Facet(height);
        DiscLight light = disc.LightAt(point, normal, hidden: 0);
        Assert.Equal(1.0, light.VisibleFraction);

        // A cosine's mean over the disc is less by its second derivative's share: height * slope^2 / 4.
        Assert.Equal(height * (1.0 - (disc.Slope * disc.Slope / 4.0)), light.Irradiance, 1e-7);
    }

    [Fact]
    public void LightAt_CentreInTheFacetsPlane_IsHalfTheDisc()
    {
        SunDisc disc = new(Sun);
        (Vector3D point, Vector3D normal) = Facet(0.0);
        DiscLight light = disc.LightAt(point, normal, hidden: 0);
        Assert.Equal(0.5, light.VisibleFraction, 0.046); // three of 64 points: as well as they can halve the disc

        // Mean of x over the half x > 0 of a disc of radius s, and 0 elsewhere: 2 s / (3 pi).
        Assert.Equal(2.0 * disc.Slope / (3.0 * Math.PI), light.Irradiance, 0.03 * disc.Slope);
    }

    [Fact]
    public void LightAt_HiddenPoints_GiveNothing()
    {
        SunDisc disc = new(Sun);
        (Vector3D point, Vector3D normal) = Facet(0.5);
        Assert.Equal(default, disc.LightAt(point, normal, SunDisc.All));
        DiscLight light = disc.LightAt(point, normal, 0xFFFF_0000_FF00_0000);
        Assert.Equal(40.0 / 64.0, light.VisibleFraction);
        Assert.Equal(0.5 * 40.0 / 64.0, light.Irradiance, 5e-3); // of the disc's radius, by the points that are hidden
    }

    [Fact]
    public void MayLight_NoPointLightsTheFacet_IsFalseOnlyThere()
    {
        SunDisc disc = new(Sun);
        for (int step = -200; step <= 200; step++)
        {
            double height = step / 100.0 * disc.Slope;
            (Vector3D point, Vector3D normal) = Facet(height);
            bool isLit = disc.LightAt(point, normal, hidden: 0).VisibleFraction > 0.0;
            Assert.True(!isLit || disc.MayLight(height));
            Assert.False(step < -105 && disc.MayLight(height));
        }
    }

    [Fact]
    public void Constructor_MoonInsideTheSun_IsRefused() =>
        Assert.Contains("inside the Sun", Assert.Throws<BadInputException>(() => new SunDisc(6e8 * Vector3D.UnitX)).Message);

    /// <summary>A point and a normal whose cosine of incidence for the Sun's centre is given.</summary>
    private static (Vector3D Point, Vector3D Normal) Facet(double cosIncidence)
    {
        Vector3D point = new(1.0e6, 1.2e6, 0.7e6);
        LightFrame axes = new(Sun - point, Vector3D.UnitZ);
        return (point, (cosIncidence * -axes.AxisW) + (Math.Sqrt(1.0 - (cosIncidence * cosIncidence)) * axes.AxisU));
    }
}
