using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Sampling;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Render.Sampling;

/// <summary>
/// What the samples of a grid share, brightness and light of facets and of their parts in pixels, is as if each sample were looked at: as
/// the pixels of an image with so many times the width and height.
/// </summary>
public sealed class GridPassTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    /// <summary>1: the angle to the Sun is not quite the same all over a facet.</summary>
    private const double OfBrightness = 1e-6;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64) };

    public static TheoryData<string> Scenes => [.. RenderScenes.Names];

    public static TheoryData<string> Nested => [.. NestedScenes.Names];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Run_AnyScene_IsTheMeanOfItsSamples(string name)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        int across = 2 + (name.Length % 3);
        PinholeCamera camera = scene.Camera(rugged.Grid, 64, 96);
        PinholeCamera fine = scene.Camera(rugged.Grid, across * 64, across * 96);
        Compare(new SurfaceModel(rugged.Grid), new NativeRenderer(rugged.Grid), camera, fine, new SceneLight(scene.Sun, IsSun: true));
    }

    [Theory]
    [MemberData(nameof(Nested))]
    public void Run_SeveralModels_IsTheMeanOfItsSamples(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("south-pole") with { Height = 300e3, Tilt = 20.0 };
        Compare(
            terrain.Surface, new NativeRenderer(terrain), scene.Camera(terrain, 60, 60), scene.Camera(terrain, 180, 180),
            new SceneLight(scene.Sun, IsSun: true));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(8)]
    public void Run_PinholeOffCentreWithSkew_IsTheMeanOfItsSamples(int across)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("oblique-20km");
        CameraState state = scene.Camera(rugged.Grid, 30, 41).State;
        CameraModel model = new(30, 41, (40.0, 37.0), (3.0, 24.5), skew: 1.5);

        // The first pixel's centre is (1, 1): that of the first sample of a pixel is 1/2 - 1/(2 n) of a pixel before.
        double Finer(double middle) => (across * (middle - 0.5)) + 0.5;
        CameraModel fine = new(
            across * 30, across * 41, (across * 40.0, across * 37.0), (Finer(3.0), Finer(24.5)), skew: across * 1.5);
        Compare(
            new SurfaceModel(rugged.Grid), new NativeRenderer(rugged.Grid), model.At(state), fine.At(state),
            new SceneLight(scene.Sun, IsSun: true));
    }

    [Fact]
    public void Run_NothingButSky_IsBlack()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("half-sky") with { Tilt = 170.0 };
        SurfaceModel surface = new(rugged.Grid);
        VisibilityPass visibility = new(surface);
        visibility.Prepare(scene.Camera(rugged.Grid, 20, 20), 1, CancellationToken.None);
        double[] factors = [.. Enumerable.Repeat(1.0, 400)];

        new GridPass(new PartPass(surface)).Run(
            surface, visibility, new SceneLight(scene.Sun, IsSun: true), new LightPass(surface), Options with { SubsamplesPerAxis = 3 },
            factors, 1, CancellationToken.None);

        Assert.All(factors, factor => Assert.Equal(0.0, factor));
    }

    /// <summary>At a low Sun some samples are looked at one by one, but where facets are large most are not.</summary>
    [Fact]
    public void Draw_FacetsOfManyPixels_LeavesFewSamples()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("nadir-100km");
        SurfaceModel surface = new(rugged.Grid);
        FrameCamera camera = scene.Camera(rugged.Grid, 200, 64);
        VisibilityPass visibility = new(surface);
        visibility.Prepare(camera, 1, CancellationToken.None);
        SceneLight sun = new(scene.Sun, IsSun: true);
        LightPass lights = new(surface);
        PixelParts others = new();
        double[] factors = new double[200 * 64];
        GridFrame frame = new(
            surface, visibility.Blocks, new ImageView(camera, 0.0, 0.0, perAxis: 4),
            lights.FindCasters(visibility.Blocks.Select(block => block.Block), sun, 128, 1, CancellationToken.None), sun.PositionBodyFixed,
            Options, factors);

        new GridWorker().Draw(frame, 0, 64, others);

        Assert.InRange(others.Count, 1, 16 * factors.Length / 5);
        Assert.InRange(factors.Count(factor => factor > 0.0), factors.Length / 4, factors.Length);
    }

    private static void Compare(SurfaceModel surface, NativeRenderer renderer, FrameCamera camera, FrameCamera fine, SceneLight sun)
    {
        using NativeFrame single = renderer.Render(fine, sun, Options, threads: 2);
        int across = fine.Width / camera.Width;
        VisibilityPass visibility = new(surface);
        visibility.Prepare(camera, 2, CancellationToken.None);
        double[] factors = new double[camera.Width * camera.Height];

        new GridPass(new PartPass(surface)).Run(
            surface, visibility, sun, new LightPass(surface), Options with { SubsamplesPerAxis = across }, factors, 2,
            CancellationToken.None);

        double brightest = 0.0;
        for (int pixel = 0; pixel < factors.Length; pixel++)
        {
            (int row, int column) = Math.DivRem(pixel, camera.Width);
            double mean = 0.0;
            for (int sample = 0; sample < across * across; sample++)
            {
                int place = (((across * row) + (sample / across)) * fine.Width) + (across * column) + (sample % across);
                mean += single.RadianceFactors[place] / (across * across);
            }

            Assert.InRange(factors[pixel], (1.0 - OfBrightness) * mean, (1.0 + OfBrightness) * mean);
            brightest = Math.Max(brightest, mean);
        }

        Assert.InRange(brightest, 1e-3, 1.0);
    }
}
