using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Render.Photometry;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>Samples where they matter: the error that is asked for, the same bytes for any number of threads, every option.</summary>
public sealed class NativeRendererAdaptiveTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private const int White = 65535;
    private const double FineLevels = 257.0; // of 65535 in one of 255

    /// <summary>Few pixels of so small an image tell the error.</summary>
    private const double Overshoot = 1.5;

    private static readonly GreyScale Grey = new();

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    private static readonly Dictionary<string, double> NoParameters = [];

    private readonly NativeRenderer _renderer = new(rugged.Grid);

    /// <summary>Facets larger than pixels and far smaller ones, silhouettes, shadows, a low Sun.</summary>
    [Theory]
    [InlineData("nadir-100km", 0.5)]
    [InlineData("oblique-20km", 0.4)]
    [InlineData("limb", 0.4)]
    [InlineData("north-pole", 0.4)]
    [InlineData("whole-disc", 3.0)]
    public void Render_WithAnError_LeavesAboutSoMuch(string scene, double error)
    {
        (PinholeCamera camera, SceneLight sun) = Scene(scene, 80, 80);
        double[] truth = Levels(camera, sun, Options with { SubsamplesPerAxis = 8 });

        Assert.InRange(Rms(truth, Levels(camera, sun, Adaptive(error))), 0.0, Overshoot * error);
    }

    [Fact]
    public void Render_ASmallError_TakesMoreSamplesThanALargeOne()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("oblique-20km", 80, 80);
        double[] truth = Levels(camera, sun, Options with { SubsamplesPerAxis = 8 });

        double one = Rms(truth, Levels(camera, sun, Options));
        double large = Rms(truth, Levels(camera, sun, Adaptive(1.0)));
        double small = Rms(truth, Levels(camera, sun, Adaptive(0.1)));

        Assert.True(small < 0.3 * large && large < 0.7 * one, $"{one}, {large}, {small}");
    }

    [Theory]
    [InlineData("oblique-20km", 2)]
    [InlineData("north-pole", 5)]
    [InlineData("whole-disc", 3)]
    public void Render_MoreThreads_IsTheSameToTheBit(string scene, int threads)
    {
        (PinholeCamera camera, SceneLight sun) = Scene(scene, TestLength.Of(83, 150), TestLength.Of(70, 133));
        foreach (NativeRenderOptions options in Kinds())
        {
            FrameValues one = FrameValues.Of(_renderer, camera, sun, options, threads: 1);
            FrameValues many = FrameValues.Of(new NativeRenderer(rugged.Grid), camera, sun, options, threads);

            Assert.Equal(one, many);
        }
    }

    [Fact]
    public void Render_FramesOfOtherSizesInBetween_IsTheSameToTheBit()
    {
        (PinholeCamera big, SceneLight bigSun) = Scene("wide-angle", 200, 90);
        (PinholeCamera small, SceneLight smallSun) = Scene("limb-backlit", 7, 65);
        FrameValues expectedBig = FrameValues.Of(new NativeRenderer(rugged.Grid), big, bigSun, Adaptive(0.5), threads: 2);
        FrameValues expectedSmall = FrameValues.Of(new NativeRenderer(rugged.Grid), small, smallSun, Adaptive(0.5), threads: 2);

        foreach (int _ in Enumerable.Range(0, 2))
        {
            Assert.Equal(expectedBig, FrameValues.Of(_renderer, big, bigSun, Adaptive(0.5), threads: 2));
            Assert.Equal(expectedSmall, FrameValues.Of(_renderer, small, smallSun, Adaptive(0.5), threads: 2));
        }
    }

    /// <summary>What is not sampled again keeps the bytes of one sample; what is, comes near 64.</summary>
    [Fact]
    public void Render_PixelsWithoutContrast_KeepTheirBytes()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("nadir-100km", 120, 120);
        using NativeFrame one = _renderer.Render(camera, sun, Options, threads: 2);
        using NativeFrame many = _renderer.Render(camera, sun, Options with { SubsamplesPerAxis = 8 }, threads: 2);

        using NativeFrame frame = _renderer.Render(camera, sun, Adaptive(1.0), threads: 2);

        int kept = 0;
        int nearer = 0;
        for (int pixel = 0; pixel < frame.RadianceFactors.Length; pixel++)
        {
            double factor = frame.RadianceFactors[pixel];
            double truth = many.RadianceFactors[pixel];
            kept += factor == one.RadianceFactors[pixel] ? 1 : 0;
            nearer += Math.Abs(factor - truth) < 0.5 * Math.Abs(one.RadianceFactors[pixel] - truth) ? 1 : 0;
        }

        Assert.InRange(kept, 5000, 14_000);
        Assert.InRange(nearer, 200, 14_400 - kept);
    }

    [Fact]
    public void TryGet_AdaptiveSamples_TellsWhatThePixelCentresShow()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("limb", 60, 60);

        FrameValues frame = FrameValues.Of(_renderer, camera, sun, Adaptive(0.3), threads: 2);

        Assert.Equal(FrameValues.Of(_renderer, camera, sun, Options, threads: 2).Truth, frame.Truth);
    }

    /// <summary>Laws, maps, smooth normals, the Sun's disc and a lamp: the error is that of one sample divided by at least 2.5.</summary>
    [Fact]
    public void Render_EveryKindOfLight_ComesNearSixtyFourSamples()
    {
        (PinholeCamera camera, SceneLight sun) = Scene("oblique-20km", 80, 80);
        foreach (NativeRenderOptions options in Kinds().Append(Options))
        {
            CompareWithTruth(camera, sun, options);
        }

        CompareWithTruth(camera, new SceneLight(camera.PositionBodyFixed, IsSun: false), Options);
    }

    [Theory]
    [InlineData("barrel")]
    [InlineData("fisheye")]
    [InlineData("principal-point")]
    public void Render_ALens_ComesNearSixtyFourSamples(string name)
    {
        (PinholeCamera pinhole, SceneLight sun) = Scene("oblique-20km", 80, 80);
        FrameCamera camera = LensCases.Of(name, 0.4, 80, 80).At(pinhole.State);

        CompareWithTruth(camera, sun, Options);
        Assert.Equal(
            FrameValues.Of(_renderer, camera, sun, Adaptive(0.3), threads: 1),
            FrameValues.Of(new NativeRenderer(rugged.Grid), camera, sun, Adaptive(0.3), threads: 4));
    }

    /// <summary>
    /// Shadows of far less than a pixel amid equal darkness: only trials find them, and what is rare they may miss. In these mountains, the
    /// error may then be exceeded, but it is never worse than a fifth of that of one sample.
    /// </summary>
    [Fact]
    public void Render_AnyScene_LeavesTheErrorOrAFifthOfThatOfOneSample()
    {
        foreach (string name in TestLength.IsLong ? RenderScenes.Names : ["grazing-sun", "limb-backlit"])
        {
            (PinholeCamera camera, SceneLight sun) = Scene(name, TestLength.Of(60, 300), TestLength.Of(50, 250));
            double[] truth = Levels(camera, sun, Options with { SubsamplesPerAxis = 8 });
            double one = Rms(truth, Levels(camera, sun, Options));
            double rms = Rms(truth, Levels(camera, sun, Adaptive(0.4)));
            Assert.True(rms <= Math.Max(0.4, 0.2 * one), $"{name}: {rms} levels; with one sample {one}");
        }
    }

    [Fact]
    public void Error_OutOfRange_IsRefused()
    {
        Assert.Throws<BadInputException>(() => new AdaptiveSampling(0.01, Grey));
        Assert.Throws<BadInputException>(() => new AdaptiveSampling(double.NaN, Grey));
    }

    private static NativeRenderOptions Adaptive(double error, NativeRenderOptions? options = null) =>
        (options ?? Options) with { Adaptive = new AdaptiveSampling(error, Grey) };

    private static IEnumerable<NativeRenderOptions> Kinds() =>
    [
        Adaptive(0.4, Options with { Reflectance = ReflectanceFactory.Create("moon", NoParameters) }),
        Adaptive(0.4, Options with { Reflectance = ReflectanceFactory.Create("hapke", NoParameters), Normals = NormalModel.Smooth }),
        Adaptive(0.4, Options with { Sun = SunModel.Disc }),
        Adaptive(0.4, Options with
        {
            Reflectance = ReflectanceFactory.Create("moon", NoParameters),
            Albedo = SyntheticMaps.Of(360, (column, row) => 800 + (100 * ((column + row) % 3))),
        }),
    ];

    private static double Rms(double[] a, double[] b) => Math.Sqrt(a.Zip(b, (x, y) => (x - y) * (x - y)).Average());

    private void CompareWithTruth(ICamera camera, SceneLight light, NativeRenderOptions options)
    {
        NativeRenderOptions plain = options with { Adaptive = null };
        double[] truth = Levels(camera, light, plain with { SubsamplesPerAxis = 8 });

        double one = Rms(truth, Levels(camera, light, plain));
        double adaptive = Rms(truth, Levels(camera, light, Adaptive(0.1, options)));

        Assert.True(adaptive < 0.4 * one, $"{options}: {adaptive} levels, with one sample {one}");
    }

    private double[] Levels(ICamera camera, SceneLight light, NativeRenderOptions options)
    {
        using NativeFrame frame = _renderer.Render(camera, light, options, threads: 2);
        return [.. frame.RadianceFactors.ToArray().Select(factor => Grey.Level(factor, White) / FineLevels)];
    }

    private (PinholeCamera Camera, SceneLight Sun) Scene(string name, int width, int height)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        return (scene.Camera(rugged.Grid, width, height), new SceneLight(scene.Sun, IsSun: true));
    }
}
