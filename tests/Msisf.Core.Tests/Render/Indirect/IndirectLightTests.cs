using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Render.Photometry;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>The light that ground throws on ground, against what is known of it in closed form.</summary>
public sealed class IndirectLightTests
{
    /// <summary>Depth over diameter, albedo, the Sun's elevation in degrees, bounces.</summary>
    public static TheoryData<double, double, double, int> Bowls => TestLength.IsLong
        ? new()
        {
            { 0.05, 0.05, 4.0, 1 }, { 0.05, 0.5, 4.0, 3 }, { 0.1, 0.3, 6.0, 1 }, { 0.1, 0.3, 6.0, 4 }, { 0.2, 0.05, 10.0, 1 },
            { 0.2, 0.5, 10.0, 5 }, { 0.3, 0.05, 15.0, 1 }, { 0.3, 0.5, 15.0, 1 }, { 0.3, 0.5, 15.0, 5 },
        }
        : new() { { 0.1, 0.3, 6.0, 1 }, { 0.3, 0.5, 15.0, 2 } };

    /// <summary>
    /// A. P. Ingersoll, T. Svitek, B. C. Murray, Icarus 100 (1992), p. 40: light scattered in a part of a sphere is the same all over it.
    /// </summary>
    [Theory]
    [MemberData(nameof(Bowls))]
    public void Render_ShadowInBowl_HasTheLightOfTheClosedForm(double depth, double albedo, double elevation, int bounces)
    {
        double error = TestLength.IsLong ? 0.0025 : 0.01;
        NativeRenderOptions options = PlaneView.Options(albedo) with { Indirect = new IndirectLight(bounces, error) };
        PlaneGrid bowl = PlaneGrid.Bowl(depth, TestLength.Of(500, 2000));
        using NativeFrame frame = PlaneView.Draw(bowl, elevation, TestLength.Of(12, 24), options);

        double view = 1.0 / (1.0 + (1.0 / (4.0 * depth * depth)));
        double series = Enumerable.Range(0, bounces).Sum(bounce => Math.Pow(albedo * view, bounce));
        double expected = albedo * Math.Sin(double.DegreesToRadians(elevation)) * albedo * view * (1.0 - view) * series;
        List<double> found = [.. InShadow(frame).Select(pixel => frame.RadianceFactors[pixel] / expected)];
        Assert.InRange(found.Count, 30, 10_000);
        double allowed = TestLength.IsLong ? 0.005 : 0.015; // everyday: the error that is asked for, and half as much of the coarser mesh
        Assert.InRange(found.Average(), 1.0 - allowed, 1.0 + allowed);
        Assert.InRange(Math.Sqrt(found.Average(value => (value - 1.0) * (value - 1.0))), 0.0, allowed);
        Assert.All(InShadow(frame), pixel => Assert.Equal(frame.RadianceFactors[pixel], frame.IndirectFactors[pixel]));
    }

    /// <summary>The part that is done is told row by row of groups.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Render_Progress_IsToldFromTheStartToTheEnd(int subsamples)
    {
        Told told = new();
        NativeRenderOptions options = PlaneView.Options(0.3) with
        {
            Indirect = new IndirectLight(1, 0.01),
            SubsamplesPerAxis = subsamples,
            Progress = told,
        };
        using NativeFrame frame = PlaneView.Draw(PlaneGrid.Bowl(0.2, 200), 10.0, 32, options);

        Assert.InRange(told.Parts.Count, (32 / 8) + 1, int.MaxValue); // strips are eight rows high
        Assert.All(told.Parts, part => Assert.InRange(part, 0.0, 1.0));
        Assert.InRange(told.Parts[0], 1e-6, 0.1);
        Assert.Equal(1.0, told.Parts[^1]);
        Assert.InRange(told.Parts.Distinct().Count(), 5, int.MaxValue);
    }

    private sealed class Told : IProgress<double>
    {
        public List<double> Parts { get; } = [];

        public void Report(double value)
        {
            lock (Parts)
            {
                Parts.Add(value);
            }
        }
    }

    /// <summary>
    /// What the bowl throws on itself is the part f of all that it reflects: over its whole ground, lit or not, no light is lost or made.
    /// </summary>
    [Fact]
    public void Render_WholeBowl_GetsThePartOfItsLightThatDoesNotLeaveIt()
    {
        const double Albedo = 0.4;
        const double Elevation = 20.0;
        NativeRenderOptions options = PlaneView.Options(Albedo) with { Indirect = new IndirectLight(1, 0.01) };
        PlaneGrid bowl = PlaneGrid.Bowl(0.2, TestLength.Of(500, 2000));
        using NativeFrame frame = PlaneView.Draw(bowl, Elevation, TestLength.Of(24, 64), options);

        (double power, double area) = (0.0, 0.0);
        foreach ((int pixel, SurfaceHit hit, _) in InBowl(frame, 0.99))
        {
            double ground = 1.0 / hit.NormalBodyFixed.Z; // seen from above
            (power, area) = (power + (ground * frame.IndirectFactors[pixel]), area + ground);
        }

        double stays = 1.0 / (1.0 + (1.0 / (4.0 * 0.2 * 0.2))); // part of a sphere that is missing over the whole
        double incident = Math.Sin(double.DegreesToRadians(Elevation)) * (1.0 - stays); // on the mouth, for each area of ground
        Assert.InRange(power / area / (Albedo * Albedo * incident * stays), 0.99, 1.01);
    }

    /// <summary>
    /// From each place of a part of a sphere all others are seen alike, whatever their reflectance: what the Sun alone shows in a fine
    /// image gives the light. The reflectance of the points in shadow is seen under another Sun.
    /// </summary>
    [Fact]
    public void Render_BowlWithMap_CountsTheMapWhereLightLeavesAndWhereItArrives()
    {
        const double Depth = 0.2;
        MapExtent extent = new(-Math.PI, Math.PI / 2.0, 2.0 * Math.PI, double.DegreesToRadians(0.1));
        NativeRenderOptions options = PlaneView.Options(0.3) with
        {
            Albedo = SyntheticMaps.Of(180, 20, extent, (column, row) => 1500 + (row * 150) + (column is > 60 and < 120 ? 0 : 2000)),
        };
        PlaneGrid bowl = PlaneGrid.Bowl(Depth, 300);
        using NativeFrame frame = PlaneView.Draw(bowl, 10.0, 16, options with { Indirect = new IndirectLight(1, 0.01) });
        using NativeFrame fine = PlaneView.Draw(bowl, 10.0, 300, options);
        using NativeFrame fromAbove = PlaneView.Draw(bowl, 89.9, 16, options);

        double pitch = PlaneGrid.Diameter / PlaneView.Height / fine.Camera.Width;
        double sum = 0.0;
        foreach ((int pixel, SurfaceHit hit, _) in InBowl(fine, 1.0))
        {
            Vector3D away = fine.Camera.PositionBodyFixed - hit.PointBodyFixed;
            double ground = pitch * pitch * away.Z * away.Z * (away.Normalized().Z / Vector3D.Dot(away.Normalized(), hit.NormalBodyFixed));
            sum += ground * fine.RadianceFactors[pixel];
        }

        double radius = PlaneGrid.Diameter * (Depth + (0.25 / Depth)) / 2.0;
        List<double> reflectances = [];
        List<double> ratios = [];
        foreach (int pixel in InShadow(frame))
        {
            SurfaceHit hit = fromAbove.TryGet((pixel % 16) + 1, (pixel / 16) + 1, out SurfaceHit found, out _) ? found : default;
            reflectances.Add(fromAbove.RadianceFactors[pixel] / hit.NormalBodyFixed.Z);
            ratios.Add(frame.IndirectFactors[pixel] / (reflectances[^1] * sum / (4.0 * Math.PI * radius * radius)));
        }

        Assert.InRange(reflectances.Max() / reflectances.Min(), 1.5, 10.0);
        Assert.InRange(ratios.Average(), 0.98, 1.02);
        // facets in place of a sphere, and cells in place of facets
        Assert.InRange(Math.Sqrt(ratios.Average(ratio => (ratio - 1.0) * (ratio - 1.0))), 0.0, 0.03);
    }

    /// <summary>A rectangle of even brightness.</summary>
    [Fact]
    public void Render_ShadowedSlopeOverLitPlane_HasTheLightOfTheClosedForm()
    {
        const double Albedo = 0.3;
        const double Half = 1000.0;
        const double Crest = 400.0;
        double elevation = double.DegreesToRadians(44.5); // behind a slope of 45 degrees
        PlaneGrid grid = new(10.0, 201, (_, y) => Math.Clamp(y, 0.0, Crest));
        PinholeCamera camera = new(
            new Vector3D(0.0, 0.0, PlaneView.Radius + 20_000.0), CameraCases.Attitude(-Vector3D.UnitZ, Vector3D.UnitY), 0.035, 24, 24);
        SceneLight sun = new(
            new Vector3D(0.0, 1.5e11 * Math.Cos(elevation), PlaneView.Radius + (1.5e11 * Math.Sin(elevation))), IsSun: true);
        NativeRenderOptions options = PlaneView.Options(Albedo) with { Indirect = new IndirectLight(1, TestLength.IsLong ? 0.0025 : 0.01) };
        using NativeFrame frame = new NativeRenderer(grid).Render(camera, sun, options, threads: 2);

        double shadow = Crest - (Crest / Math.Tan(elevation)); // how far the slope darkens the plane
        Vector3D[] lit = [new(-Half, -Half, 0.0), new(Half, -Half, 0.0), new(Half, shadow, 0.0), new(-Half, shadow, 0.0)];
        List<double> ratios = [];
        foreach ((int pixel, SurfaceHit hit, _) in InBowl(frame, 1.0))
        {
            Vector3D point = hit.PointBodyFixed - (PlaneView.Radius * Vector3D.UnitZ);
            if (point.Y is > 40.0 and < 380.0)
            {
                double seen = PlaneView.PartOf([.. lit.Select(corner => corner - point)], hit.NormalBodyFixed);
                ratios.Add(frame.IndirectFactors[pixel] / (Albedo * Albedo * Math.Sin(elevation) * seen));
            }
        }

        Assert.InRange(ratios.Count, 30, 300);
        Assert.InRange(ratios.Average(), 0.99, 1.01);
        Assert.InRange(Math.Sqrt(ratios.Average(ratio => (ratio - 1.0) * (ratio - 1.0))), 0.0, 0.02); // cells in place of points
    }

    /// <summary>Hills on a strip: few of the points that stand for the ground of a view are there, so that bounces take a moment.</summary>
    [Fact]
    public void Render_OtherThreads_HasTheSameBits()
    {
        NativeRenderOptions options = PlaneView.Options(0.3) with
        {
            Indirect = new IndirectLight(2, 0.05),
            Sun = SunModel.Disc,
            Reflectance = new LommelSeeligerReflectance(0.2),
            SubsamplesPerAxis = 2,
        };
        PolarFunctionGrid strip = new(
            new PolarStereographic(false, 30.0, 45.0, 4.0), 91, 9, (line, sample) => 100.0 * Math.Sin(line) * Math.Cos(sample));
        using NativeFrame one = PlaneView.Draw(strip, 20.0, 24, options, threads: 1);
        using NativeFrame three = PlaneView.Draw(strip, 20.0, 24, options, threads: 3);

        Assert.InRange(one.IndirectFactors.ToArray().Count(light => light > 0.0), 60, 576);
        Assert.Equal(one.RadianceFactors, three.RadianceFactors);
        Assert.Equal(one.IndirectFactors, three.IndirectFactors);
    }

    /// <summary>The light is added to what the Sun alone gives, also with more samples where they matter.</summary>
    [Theory]
    [InlineData(1, false)]
    [InlineData(3, false)]
    [InlineData(1, true)]
    public void Render_WithIndirect_AddsItsLayer(int perAxis, bool isAdaptive)
    {
        PlaneGrid bowl = PlaneGrid.Bowl(0.2, 60);
        NativeRenderOptions alone = PlaneView.Options(0.3) with
        {
            SubsamplesPerAxis = perAxis,
            Adaptive = isAdaptive ? new AdaptiveSampling(2.0, new GreyScale(1.0, GreyTransfer.Linear)) : null,
        };
        using NativeFrame without = PlaneView.Draw(bowl, 10.0, 8, alone);
        using NativeFrame with = PlaneView.Draw(bowl, 10.0, 8, alone with { Indirect = new IndirectLight(1, 0.2) });

        Assert.True(without.IndirectFactors.IsEmpty);
        double added = Enumerable.Range(0, 64).Sum(pixel => with.RadianceFactors[pixel] - without.RadianceFactors[pixel]);
        double indirect = Enumerable.Range(0, 64).Sum(pixel => with.IndirectFactors[pixel]);
        double allowed = isAdaptive ? 0.05 : 1e-9; // of the Sun's much brighter light, other samples count then
        Assert.InRange(added / indirect, 1.0 - allowed, 1.0 + allowed);
        Assert.All(Enumerable.Range(0, 64), pixel => Assert.InRange(with.IndirectFactors[pixel], 0.0, 0.3 * 0.3 * 0.3));
    }

    /// <summary>The pixels in the bowl's shadow, but for those beside its rim, where facets are no longer a sphere.</summary>
    private static List<int> InShadow(NativeFrame frame) =>
        [.. InBowl(frame, 0.96).Where(one => one.Light.State == IlluminationState.Shadow).Select(one => one.Pixel)];

    /// <summary>The pixels that see the bowl.</summary>
    /// <param name="frame">The image.</param>
    /// <param name="part">Up to this part of the bowl's radius.</param>
    private static IEnumerable<(int Pixel, SurfaceHit Hit, PixelIllumination Light)> InBowl(NativeFrame frame, double part) =>
        PlaneView.Within(frame, part * PlaneGrid.Diameter / 2.0);
}
