using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class CelestialBodyTests
{
    /// <summary>m over a sphere: fill values that files have, in their own steps of 1 m.</summary>
    private static readonly double[] Fills = [-32768.0, 32767.0, -3.4e38, 1e32];

    /// <summary>
    /// The extremes that are published, km over the sphere of a product. Mars: Hellas and Olympus Mons over the areoid; and the poles and
    /// Olympus Mons (radius 3,417 km) over the mean sphere, as in models of radii. Io: axes and the highest mountain.
    /// </summary>
    [Theory]
    [InlineData("MOON", -9.2, 10.8)]
    [InlineData("MERCURY", -5.38, 4.48)]
    [InlineData("VENUS", -3.0, 11.0)]
    [InlineData("MARS", -8.2, 21.2)]
    [InlineData("MARS", -16.0, 27.5)]
    [InlineData("MARS", -22.6, 21.2)]
    [InlineData("IO", -5.7, 17.5)]
    [InlineData("EUROPA", -3.3, 3.8)]
    [InlineData("GANYMEDE", -5.0, 5.0)]
    public void PlausibleHeights_PublishedExtremes_AreWithin(string name, double lowest, double highest)
    {
        CelestialBody body = CelestialBody.Find(name)!;

        Assert.InRange(1000.0 * lowest, body.PlausibleHeights.Min, 0.0);
        Assert.InRange(1000.0 * highest, 0.0, body.PlausibleHeights.Max);
    }

    [Fact]
    public void PlausibleHeights_EachBody_HaveNoFillsAndFitTheSurface() => Assert.All(CelestialBody.All, body =>
    {
        (double min, double max) = body.PlausibleHeights;
        Assert.DoesNotContain(Fills, fill => fill >= min && fill <= max);
        Assert.True(Math.Max(-min, max) < MoonConstants.MaxReliefOver(body.MeanRadius));
    });

    /// <summary>Mars's highest mountain, 21.2 km over the sphere of 3,396 km: straight down and along the ground.</summary>
    [Fact]
    public void TryTrace_OlympusMons_IsMet()
    {
        const double sphere = 3_396_000.0;
        const double top = 21_229.0;
        const double cellSlack = 600.0; // m: the plateau is 4 x 4 samples of 1 degree; its facets' middles lie lower by their sagitta
        FunctionGrid mars = new(
            1, (line, sample) => sphere + (line is > 69 and < 74 && sample is > 224 and < 229 ? top : 0.0))
        {
            ReferenceRadius = sphere,
        };
        TerrainTracer tracer = new(mars);
        Vector3D up = new SelenographicPoint(double.DegreesToRadians(18.0), double.DegreesToRadians(227.0)).ToDirectionBodyFixed();
        Vector3D north = new SelenographicPoint(double.DegreesToRadians(60.0), double.DegreesToRadians(227.0)).ToDirectionBodyFixed();

        Assert.True(tracer.TryTrace(new Ray(1.3 * sphere * up, -up), out SurfaceHit down));
        Assert.InRange(1.3 * sphere - down.RayParameter, sphere + top - cellSlack, sphere + top);

        // From 100 m above the sphere's horizon plane through the flank: met although it passes above 20 km.
        Vector3D over = (sphere + top - cellSlack) * up;
        Assert.True(tracer.TryTrace(new Ray(over + (2e6 * north), -north), out SurfaceHit along));
        Assert.True((over + (2e6 * north) - (along.RayParameter * north)).Length > sphere + 20_000.0);
    }
}
