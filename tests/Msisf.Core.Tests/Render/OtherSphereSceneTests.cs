using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>Bodies smaller and larger than the Moon, against rays through every facet.</summary>
public sealed class OtherSphereSceneTests
{
    private const int PixelsPerDegree = 2;
    private const int Side = 40;

    /// <summary>m: where the computed points may differ; far rays have some 1e7 m.</summary>
    private const double SamePoint = 1e-6;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    /// <param name="radius">Of Europa, Mercury and Venus, m.</param>
    /// <param name="height">Of the camera, m.</param>
    /// <param name="offNadir">Degrees, towards the west.</param>
    [Theory]
    [InlineData(1_560_800.0, 4e6, 0.0)]
    [InlineData(2_439_400.0, 5e6, 5.0)]
    [InlineData(2_439_400.0, 30e3, 75.0)]
    [InlineData(6_051_800.0, 1e7, 10.0)]
    [InlineData(6_051_800.0, 40e3, 80.0)]
    public void Render_OtherRadius_ShowsTheFacetsThatRaysHit(double radius, double height, double offNadir)
    {
        FunctionGrid grid = FunctionGrid.RuggedOn(radius, PixelsPerDegree);
        Vector3D position = (radius + height) * new Vector3D(0.6, -0.48, 0.64);
        UnitQuaternion attitude = Boresight.MoonFromCamera(
            position, Boresight.OffNadir(position, double.DegreesToRadians(offNadir), 4.7), position, 0.0);
        PinholeCamera camera = new(position, attitude, double.DegreesToRadians(50.0), Side, Side);
        SceneLight sun = new(6e10 * new Vector3D(0.8, 0.0, 0.6), IsSun: true);
        BruteForceMoon judge = new(grid);
        TerrainTracer tracer = new(grid);

        using NativeFrame drawn = new NativeRenderer(grid).Render(camera, sun, Options, threads: 2);

        (int hits, int lit) = (0, 0);
        for (int y = 1; y <= Side; y++)
        {
            for (int x = 1; x <= Side; x++)
            {
                Ray ray = camera.RayThrough(x, y);
                (BruteForceMoon.FacetId Facet, double T)? expected = judge.FirstHit(ray.Origin, ray.Direction);
                Assert.Equal(expected is not null, drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light));
                Assert.Equal(expected is not null, tracer.TryTrace(ray, out SurfaceHit traced));
                if (expected is not { } facet)
                {
                    continue;
                }

                Vector3D point = ray.Origin + (facet.T * ray.Direction);
                Assert.Equal(0.0, (hit.PointBodyFixed - point).Length, SamePoint);
                Assert.Equal(traced.Facet, hit.Facet);
                Assert.Equal(judge.IsShadowed(facet.Facet, point, sun.PositionBodyFixed), light.State != IlluminationState.Lit);
                hits++;
                lit += light.State == IlluminationState.Lit ? 1 : 0;
            }
        }

        Assert.InRange(hits, Side * Side / 10, Side * Side);
        Assert.InRange(lit, hits / 20, hits);
    }

    /// <summary>The mean of four heights over the body's own sphere, to a 32-bit float's last digit.</summary>
    [Fact]
    public void Levels_OtherRadius_AreMeansOfItsHeights()
    {
        const double Radius = 2_439_400.0;
        FunctionGrid grid = FunctionGrid.RuggedOn(Radius, 4);
        IGlobalGrid level = LodLevels.Open(grid).Level(1);
        double[] radii = new double[9];
        level.ReadRadii(100, 50, radii);

        Assert.Equal(Radius, level.ReferenceRadius);
        for (int i = 0; i < radii.Length; i++)
        {
            (int line, int sample) = (200, 2 * (50 + i));
            double mean = 0.25 * (grid.RadiusAt(line, sample) + grid.RadiusAt(line + 1, sample) + grid.RadiusAt(line, sample + 1)
                + grid.RadiusAt(line + 1, sample + 1));
            Assert.Equal(mean, radii[i], 3e-4);
        }
    }

    [Fact]
    public void RadiusBelow_OtherRadius_IsItsGround() =>
        Assert.InRange(
            TerrainHeight.RadiusBelow(FunctionGrid.RuggedOn(6_051_800.0, 1), new Vector3D(1.0, 2.0, 3.0)),
            6_051_800.0 - FunctionGrid.RuggedRelief, 6_051_800.0 + FunctionGrid.RuggedRelief);

    /// <summary>A degree of Mercury's equator has 2439.4 km * pi / 180.</summary>
    [Fact]
    public void Resolution_OnALargerSphere_HasWiderCells() =>
        Assert.Equal(42_575.6, GridResolution.FromPixelsPerDegree(1).OnSphere(2_439_400.0).MetresPerPixel, 0.1);
}
