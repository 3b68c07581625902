using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>What holds for any frame: it depends on its own camera, light and options only, and its samples are what they say.</summary>
public sealed class NativeRendererTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    /// <summary>
    /// 1: the samples on a facet may share its brightness, though the angle to the Sun is not quite the same all over it.
    /// </summary>
    private const double OfShared = 1e-6;

    /// <summary>1: the same for a law that depends on the camera's place, in pixels of a degree.</summary>
    private const double OfSharedLaw = 3e-5;

    private readonly NativeRenderer _renderer = new(rugged.Grid);

    [Theory]
    [InlineData("oblique-20km", 2)]
    [InlineData("oblique-20km", 5)]
    [InlineData("north-pole", 2)]
    [InlineData("whole-disc", 5)]
    public void Render_MoreThreads_IsTheSameToTheBit(string scene, int threads)
    {
        (PinholeCamera camera, SceneLight sun) = Scene(scene, 150, 333);

        FrameValues one = FrameValues.Of(_renderer, camera, sun, Options, threads: 1);
        FrameValues many = FrameValues.Of(new NativeRenderer(rugged.Grid), camera, sun, Options, threads);

        Assert.Equal(one, many);
    }

    [Fact]
    public void Render_FramesOfOtherSizesAndLightsInBetween_IsTheSameToTheBit()
    {
        (PinholeCamera big, SceneLight bigSun) = Scene("wide-angle", 300, 200);
        (PinholeCamera small, SceneLight smallSun) = Scene("limb-backlit", 7, 65);
        SceneLight lamp = new(big.PositionBodyFixed, IsSun: false);
        FrameValues expectedLamp = FrameValues.Of(new NativeRenderer(rugged.Grid), big, lamp, Options, threads: 2);
        FrameValues expectedBig = FrameValues.Of(new NativeRenderer(rugged.Grid), big, bigSun, Options, threads: 2);
        FrameValues expectedSmall = FrameValues.Of(new NativeRenderer(rugged.Grid), small, smallSun, Options, threads: 2);

        foreach (int _ in Enumerable.Range(0, 2))
        {
            Assert.Equal(expectedBig, FrameValues.Of(_renderer, big, bigSun, Options, threads: 2));
            Assert.Equal(expectedSmall, FrameValues.Of(_renderer, small, smallSun, Options, threads: 2));
            Assert.Equal(expectedLamp, FrameValues.Of(_renderer, big, lamp, Options, threads: 2));
        }
    }

    [Fact]
    public void Render_AfterManyFramesThatNeedLittleMemory_IsTheSameToTheBit()
    {
        (PinholeCamera big, SceneLight bigSun) = Scene("half-sky", 600, 400); // more receivers than are always kept
        (PinholeCamera small, SceneLight smallSun) = Scene("limb-backlit", 7, 65);
        FrameValues expected = FrameValues.Of(_renderer, big, bigSun, Options, threads: 2);
        long before = _renderer.ReplacedBytes;

        foreach (int _ in Enumerable.Range(0, 40))
        {
            _renderer.Render(small, smallSun, Options, threads: 1).Dispose();
        }

        Assert.NotEqual(before, _renderer.ReplacedBytes);
        Assert.Equal(expected, FrameValues.Of(_renderer, big, bigSun, Options, threads: 2));
    }

    [Fact]
    public void Render_WhileOtherFramesAreHeldAndDrawn_IsTheSameToTheBit()
    {
        (
            PinholeCamera Camera,
            SceneLight Sun)[] scenes = [.. new[] { "far", "seam", "south-pole", "half-sky" }.Select(name => Scene(name, 80, 80))];
        FrameValues[] expected = [.. scenes.Select(
            scene => FrameValues.Of(new NativeRenderer(rugged.Grid), scene.Camera, scene.Sun, Options, threads: 1))];
        FrameValues[] together = new FrameValues[scenes.Length];

        using NativeFrame held = _renderer.Render(scenes[0].Camera, scenes[0].Sun, Options, threads: 1);
        System.Threading.Tasks.Parallel.For(0, scenes.Length, index =>
            together[index] = FrameValues.Of(_renderer, scenes[index].Camera, scenes[index].Sun, Options, threads: 2));

        Assert.Equal(expected, together);
        Assert.Equal(expected[0], FrameValues.Of(held));
    }

    [Theory]
    [InlineData("limb-backlit")]
    [InlineData("one-metre")]
    [InlineData("across-pole")]
    public void Render_LampAtTheCamera_LightsAllThatIsSeen(string name)
    {
        (PinholeCamera camera, _) = Scene(name, 100, 100);

        using NativeFrame frame = _renderer.Render(camera, new SceneLight(camera.PositionBodyFixed, IsSun: false), Options, threads: 2);

        int surface = 0;
        ForEachPixel(camera, (x, y, pixel) =>
        {
            bool isSurface = frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light);
            double cosine = isSurface ? Vector3D.Dot(hit.NormalBodyFixed, (camera.PositionBodyFixed - hit.PointBodyFixed).Normalized())
                : 0.0;
            Assert.Equal(isSurface ? new PixelIllumination(IlluminationState.Lit, 1.0) : default, light);
            Assert.Equal(0.64 * cosine, frame.RadianceFactors[pixel], Rounding.OfChains);
            surface += isSurface ? 1 : 0;
        });
        Assert.InRange(surface, 1000, 9999);
    }

    /// <summary>The samples of a pixel are the pixels of an image with so many times the width and height.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    public void Render_ManySamples_IsTheMeanOfSingleImagesWithShiftedCentres(int across)
    {
        (PinholeCamera camera, SceneLight sun) = Scene("grazing-sun", 90, 60);
        PinholeCamera fine = new(
            camera.PositionBodyFixed, camera.MoonFromCamera, camera.FieldOfView, across * camera.Width, across * camera.Height);
        using NativeFrame single = _renderer.Render(fine, sun, Options, threads: 2);

        using NativeFrame frame = _renderer.Render(camera, sun, Options with { SubsamplesPerAxis = across }, threads: 2);

        int mixed = 0;
        ForEachPixel(camera, (x, y, pixel) =>
        {
            double[] samples =
            [
                .. from row in Enumerable.Range(across * (y - 1), across)
                   from column in Enumerable.Range(across * (x - 1), across)
                   select single.RadianceFactors[(row * fine.Width) + column],
            ];
            Assert.InRange(frame.RadianceFactors[pixel], (1.0 - OfShared) * samples.Average(), (1.0 + OfShared) * samples.Average());
            mixed += samples.Min() == 0.0 && samples.Max() > 0.0 ? 1 : 0;
        });
        Assert.True(mixed > 100, $"{mixed} pixels with both light and shadow say little");
    }

    public static TheoryData<string> Scenes => [.. RenderScenes.Names];

    /// <summary>
    /// Where all samples on a facet of a pixel have the same light, it is found once for them: that must be as if each were looked at.
    /// </summary>
    [Theory]
    [MemberData(nameof(Scenes))]
    public void Render_SeveralSamplesOfAnyScene_IsTheMeanOfItsSamples(string name)
    {
        int across = 2 + (name.Length % 3);
        CompareWithFine(name, across, Options with { KeepGroundTruth = false }, OfShared);
    }

    [Theory]
    [InlineData(2, "moon", SunModel.Point, OfSharedLaw)]
    [InlineData(3, "lambert", SunModel.Disc, OfShared)]
    [InlineData(9, "lambert", SunModel.Point, OfShared)]
    public void Render_SeveralSamplesByAnyLaw_IsTheMeanOfItsSamples(int across, string law, SunModel sun, double allowed)
    {
        NativeRenderOptions options = Options with
        {
            Reflectance = ReflectanceFactory.Create(law, new Dictionary<string, double>()),
            Sun = sun,
            KeepGroundTruth = across == 2,
        };
        CompareWithFine("south-pole", across, options, allowed);
    }

    private void CompareWithFine(string name, int across, NativeRenderOptions options, double allowed)
    {
        (PinholeCamera camera, SceneLight sun) = Scene(name, 64, 96);
        PinholeCamera fine = new(
            camera.PositionBodyFixed, camera.MoonFromCamera, camera.FieldOfView, across * camera.Width, across * camera.Height);
        using NativeFrame single = _renderer.Render(fine, sun, options, threads: 2);

        using NativeFrame frame = _renderer.Render(camera, sun, options with { SubsamplesPerAxis = across }, threads: 2);

        ForEachPixel(camera, (x, y, pixel) =>
        {
            double mean = 0.0;
            for (int sample = 0; sample < across * across; sample++)
            {
                int row = (across * (y - 1)) + (sample / across);
                mean += single.RadianceFactors[(row * fine.Width) + (across * (x - 1)) + (sample % across)] / (across * across);
            }

            Assert.InRange(frame.RadianceFactors[pixel], (1.0 - allowed) * mean, (1.0 + allowed) * mean);
        });
    }

    [Fact]
    public void Render_NineSamples_AreNearerToSixtyFourThanOneIs()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("grazing-sun", 60, 60);
        double[] best = Radiance(camera, sun, 8);

        double ErrorOf(int across) => Math.Sqrt(best.Zip(Radiance(camera, sun, across), (a, b) => (a - b) * (a - b)).Average());

        Assert.InRange(ErrorOf(3), 1e-6, 0.5 * ErrorOf(1));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    public void TryGet_ManySamples_TellsWhatThePixelCentresShow(int across)
    {
        (PinholeCamera camera, SceneLight sun) = Scene("limb", 60, 60);
        FrameValues centres = FrameValues.Of(_renderer, camera, sun, Options, threads: 2);

        FrameValues many = FrameValues.Of(_renderer, camera, sun, Options with { SubsamplesPerAxis = across }, threads: 2);

        Assert.Equal(centres.Truth, many.Truth);
        Assert.NotEqual(centres.RadianceFactors, many.RadianceFactors);
    }

    [Fact]
    public void TryGet_WithoutTruth_IsRefused()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("seam", 4, 4);
        using NativeFrame frame = _renderer.Render(camera, sun, Options with { KeepGroundTruth = false }, threads: 1);

        Assert.Throws<InvalidOperationException>(() => frame.TryGet(1, 1, out _, out _));
    }

    [Fact]
    public void RadianceFactors_OfAFrameGivenBack_AreRefused()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("seam", 4, 4);
        NativeFrame frame = _renderer.Render(camera, sun, Options, threads: 1);
        frame.Dispose();
        frame.Dispose();

        Assert.Throws<ObjectDisposedException>(() => frame.RadianceFactors.Length);
    }

    [Fact]
    public void Render_Cancelled_EndsAndTheNextFrameIsWhole()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("seam", 50, 50);
        FrameValues expected = FrameValues.Of(_renderer, camera, sun, Options, threads: 2);

        Assert.ThrowsAny<OperationCanceledException>(
            () => _renderer.Render(camera, sun, Options, threads: 2, new CancellationToken(canceled: true)));

        Assert.Equal(expected, FrameValues.Of(_renderer, camera, sun, Options, threads: 2));
    }

    private static void ForEachPixel(PinholeCamera camera, Action<int, int, int> look)
    {
        for (int pixel = 0; pixel < camera.Width * camera.Height; pixel++)
        {
            look((pixel % camera.Width) + 1, (pixel / camera.Width) + 1, pixel);
        }
    }

    private double[] Radiance(PinholeCamera camera, SceneLight sun, int across)
    {
        using NativeFrame frame = _renderer.Render(camera, sun, Options with { SubsamplesPerAxis = across }, threads: 2);
        return frame.RadianceFactors.ToArray();
    }

    private (PinholeCamera Camera, SceneLight Sun) Scene(string name, int width, int height)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        return (scene.Camera(rugged.Grid, width, height), new SceneLight(scene.Sun, IsSun: true));
    }
}
