using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

public sealed class PenumbraPassTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    /// <summary>degrees east: where the Sun's centre sets over the ramp's shadow.</summary>
    private const double Terminator = 27.0;

    private static readonly FunctionGrid Rough = FunctionGrid.Rough(2);

    [RequiresTheory(Part.Ldem4)]
    [InlineData(-89.0, 40.0, 2.0, false)]
    [InlineData(-89.0, 40.0, 2.0, true)]
    [InlineData(-43.0, 349.0, 2.0, false)]
    [InlineData(-43.0, 349.0, 2.0, true)]
    public void Run_RealModel_IsWhatEveryFacetSaysOfEachPoint(double latitude, double longitude, double radius, bool findsDarkZones) =>
        Compare(ldem4.Grid, ldem4.Moon, SurfacePoints.Direction(latitude, longitude), radius, findsDarkZones);

    [Theory]
    [InlineData(90.0, 0.0, 5.0, false)]
    [InlineData(90.0, 0.0, 5.0, true)]
    [InlineData(6.0, 359.0, 20.0, false)]
    [InlineData(6.0, 359.0, 20.0, true)]
    public void Run_RoughMoon_IsWhatEveryFacetSaysOfEachPoint(double latitude, double longitude, double radius, bool findsDarkZones) =>
        Compare(Rough, new BruteForceMoon(Rough), SurfacePoints.Direction(latitude, longitude), radius, findsDarkZones);

    /// <summary>
    /// Behind a long straight wall the Sun sets by the closed form of a segment: (acos d - d sqrt(1 - d^2)) / pi of the disc is above an
    /// edge d radii over its centre.
    /// </summary>
    [Fact]
    public void Run_BehindALongWall_ShowsTheSegmentOfTheDiscAboveIt()
    {
        const int wall = 80;
        FunctionGrid grid = FunctionGrid.OfHeights(4, (_, sample) => sample == wall ? 5000.0 : 0.0);
        double longitude = (wall + 0.5) / 4.0;
        SunDisc disc = new(1.5e11 * SurfacePoints.Direction(0.125, longitude - 85.0)); // west of it, on the parallel of a line of samples
        Vector3D top = 1_742_400.0 * SurfacePoints.Direction(0.125, longitude);
        List<Vector3D> points = [];
        List<double> fractions = [];
        for (int i = 0; i < 400; i++)
        {
            Vector3D point = GroundPoint(grid, longitude + 2.2 + (i / 400.0 * 0.6));
            double sunAngle = Math.Atan2(
                Vector3D.Dot(point.Normalized(), disc.CentreBodyFixed - point),
                Vector3D.Cross(point.Normalized(), disc.CentreBodyFixed - point).Length);
            double wallAngle = Math.Atan2(
                Vector3D.Dot(point.Normalized(), top - point), Vector3D.Cross(point.Normalized(), top - point).Length);
            double edge = Math.Clamp((wallAngle - sunAngle) / Math.Atan(disc.Slope), -1.0, 1.0);
            points.Add(point);
            fractions.Add((Math.Atan2(Math.Sqrt(1.0 - (edge * edge)), edge) - (edge * Math.Sqrt(1.0 - (edge * edge)))) / Math.PI);
        }

        ulong[] hidden = Run(new PenumbraPass(new SurfaceModel(grid)), points, disc, 1);
        for (int i = 0; i < points.Count; i++)
        {
            // three of 64 points: as well as they can halve the disc
            Assert.Equal(fractions[i], 1.0 - (ulong.PopCount(hidden[i]) / 64.0), 0.046);
        }

        Assert.InRange(fractions.Count(fraction => fraction is > 0.05 and < 0.95), 50, 350);
    }

    /// <summary>Around the shadow of a ramp whose top is parallel to the rays, so that each plane that cuts it shows its top.</summary>
    [Fact]
    public void Run_WithDarkZones_GivesTheSameAsWithout()
    {
        const double edge = 1_742_400.0; // m from the Moon's centre, at the ramp's lower, eastern edge
        const int edgeSample = 88;
        FunctionGrid grid = FunctionGrid.OfHeights(4, (line, sample) =>
        {
            bool isRamp = line is >= 356 and <= 363 && sample is > edgeSample - 5 and <= edgeSample;
            return isRamp ? (edge * CosFromTerminator(edgeSample) / CosFromTerminator(sample)) - 1_737_400.0 : 0.0;
        });
        SunDisc disc = new(1.5e11 * SurfacePoints.Direction(0.0, Terminator - 90.0));
        List<Vector3D> points = [];
        for (int i = 0; i < 40 * 200; i++)
        {
            Vector3D direction = SurfacePoints.Direction((0.09 * (i / 200)) - 1.8, 22.4 + (0.015 * (i % 200)));
            points.Add(TerrainHeight.RadiusBelow(grid, direction) * direction);
        }

        ulong[] expected = Run(new PenumbraPass(new SurfaceModel(grid), false), points, disc, 2);
        Assert.InRange(expected.Count(mask => mask == SunDisc.All), 1000, 7000);
        Assert.InRange(expected.Count(mask => mask is not 0 and not SunDisc.All), 300, 7000);
        Assert.Equal(expected, Run(new PenumbraPass(new SurfaceModel(grid), true), points, disc, 2));
    }

    [Fact]
    public void Run_AnyNumberOfThreads_GivesTheSame()
    {
        BruteForceMoon moon = new(Rough);
        Vector3D middle = SurfacePoints.Direction(0.0, 0.0);
        SunDisc disc = new(SurfacePoints.Sun(middle, 4.0, 50.0));
        List<Vector3D> points = [.. SurfacePoints.Facing(
            moon, middle, 30.0, disc.CentreBodyFixed, 3000, new Random(11), -0.004).Select(point => point.Position)];
        PenumbraPass pass = new(new SurfaceModel(Rough));
        ulong[] expected = Run(pass, points, disc, 1);
        Assert.Contains(expected, mask => mask is not 0 and not SunDisc.All);
        Assert.Equal(expected, Run(pass, points, disc, 2));
        Assert.Equal(expected, Run(pass, points, disc, 7));
    }

    /// <summary>
    /// Where zones hide less than a twentieth of the receivers, the next fifteen frames do without; where they hide more, each has them.
    /// The result is the same.
    /// </summary>
    [Fact]
    public void Run_ZonesThatHideLittle_AreNotLookedForInTheNextFrames()
    {
        BruteForceMoon moon = new(Rough);
        Vector3D middle = SurfacePoints.Direction(0.0, 0.0);
        SunDisc disc = new(SurfacePoints.Sun(middle, 4.0, 50.0));
        Vector3D[] all = [.. SurfacePoints.Facing(
            moon, middle, 20.0, disc.CentreBodyFixed, 3000, new Random(11), 0.01).Select(point => point.Position)];
        ulong[] hidden = Run(new PenumbraPass(new SurfaceModel(Rough), false), all, disc, 2);
        Vector3D[] lit = [.. all.Where((_, i) => hidden[i] == 0)];
        Assert.InRange(lit.Length, 20, 2_700);

        PenumbraPass pass = new(new SurfaceModel(Rough), findsDarkZones: true);
        List<bool> ofLit = [];
        for (int frame = 0; frame < 18; frame++)
        {
            Assert.All(Run(pass, lit, disc, 2), mask => Assert.Equal(0UL, mask));
            ofLit.Add(pass.FoundZones);
        }

        Assert.Equal([true, .. Enumerable.Repeat(false, 15), true, false], ofLit);
        for (int frame = 0; frame < 18; frame++)
        {
            Assert.Equal(hidden, Run(pass, all, disc, 2));
            Assert.Equal(frame >= 14, pass.FoundZones);
        }
    }

    [Fact]
    public void Run_DeepNight_HidesTheWholeDisc()
    {
        SunDisc disc = new(SurfacePoints.Sun(SurfacePoints.Direction(0.0, 0.0), -40.0, 0.0));
        ulong[] hidden = Run(new PenumbraPass(new SurfaceModel(Rough)), [1_740_000.0 * SurfacePoints.Direction(0.0, 0.0)], disc, 1);
        Assert.Equal(SunDisc.All, hidden[0]);
    }

    private static double CosFromTerminator(int sample) => Math.Cos((((sample + 0.5) / 4.0) - Terminator) * Math.PI / 180.0);

    private static void Compare(IGlobalGrid grid, BruteForceMoon moon, Vector3D middle, double radius, bool findsDarkZones)
    {
        Random random = new(20120222);
        PenumbraPass pass = new(new SurfaceModel(grid), findsDarkZones);
        int partly = 0;
        foreach (double elevation in new[] { -0.3, 0.5, 2.0, 6.0 })
        {
            SunDisc disc = new(SurfacePoints.Sun(middle, elevation, 360.0 * random.NextDouble()));
            List<SurfacePoint> points = SurfacePoints.Facing(moon, middle, radius, disc.CentreBodyFixed, 60, random, -disc.Slope);
            ulong[] hidden = Run(pass, [.. points.Select(point => point.Position)], disc, 2);
            for (int i = 0; i < points.Count; i++)
            {
                SurfacePoint point = points[i];
                Vector3D normal = moon.Normal(point.Facet);
                ulong different = 0;
                for (int bit = 0; bit < SunDisc.Points; bit++)
                {
                    Vector3D target = disc.PointsBodyFixed[bit];

                    // Where the facet's own plane hides a point of the disc, it does not matter what else does.
                    bool isAbove = Vector3D.Dot(normal, (target - point.Position).Normalized()) > SurfacePoints.MinCosine;
                    bool isHidden = isAbove && moon.IsShadowed(point.Facet, point.Position, target);
                    different |= isAbove && isHidden != ((hidden[i] >> bit & 1) != 0) ? 1UL << bit : 0;
                }

                Assert.True(different == 0, $"Sun {elevation}: {point}, {different:X16} of {hidden[i]:X16}");
                partly += hidden[i] is not 0 and not SunDisc.All ? 1 : 0;
            }
        }

        Assert.InRange(partly, 3, 200);
    }

    /// <summary>The ground on the equator side of the first line of samples south of it, where facets join samples of height 0.</summary>
    private static Vector3D GroundPoint(FunctionGrid grid, double longitude)
    {
        Vector3D direction = SurfacePoints.Direction(0.125, longitude);
        return TerrainHeight.RadiusBelow(grid, direction) * direction;
    }

    private static ulong[] Run(PenumbraPass pass, IReadOnlyList<Vector3D> points, SunDisc disc, int threads)
    {
        PointReceivers receivers = new(points, 50);
        ulong[] hidden = new ulong[receivers.Rows * receivers.Width];
        pass.Run(receivers, disc, hidden, threads, default);
        return hidden;
    }
}
