using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Tests.Render.Photometry;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>
/// The samples of a grid share what they can. The oracle looks at each: an image of one sample a pixel, whose pixels are the samples.
/// </summary>
public sealed class NativeRendererSamplesTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    /// <summary>1: samples on a facet are shaded where their mean is.</summary>
    private const double OfBrightness = 1e-6;

    /// <summary>Of half the field of view where the law depends on the camera's place: over 0.05 degrees it is linear to 1e-6.</summary>
    private const double NarrowTangent = 0.02;

    /// <summary>The error against 64 samples may grow by no more than this: samples share their brightness.</summary>
    private const double OfError = 1.02;

    /// <summary>
    /// The same where smooth ground turns away from the Sun within a pixel, as brightness is not linear there: 5.5e-5 of the radiance
    /// factor for 4.9e-5 in pixels of a degree.
    /// </summary>
    private const double OfErrorAtTerminator = 1.15;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64) };

    private readonly NativeRenderer _renderer = new(rugged.Grid);

    public static TheoryData<string> Nested => [.. NestedScenes.Names];

    public static TheoryData<string> Lenses => [.. LensCases.Names];

    [Theory]
    [MemberData(nameof(Nested))]
    public void Render_SeveralModels_IsTheMeanOfItsSamples(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("south-pole") with { Height = 300e3, Tilt = 20.0 };
        CameraModel model = new(60, 60, (52.0, 52.0), (30.5, 30.5));
        Compare(new NativeRenderer(terrain), scene, model, scene.Camera(terrain, 60, 60).State, 3, Options);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(8)]
    [InlineData(9)]
    public void Render_PinholeOffCentreWithSkew_IsTheMeanOfItsSamples(int perAxis)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("oblique-20km");
        CameraModel model = new(30, 41, (40.0, 37.0), (3.0, 24.5), skew: 1.5);
        Compare(_renderer, scene, model, scene.Camera(rugged.Grid, 30, 41).State, perAxis, Options);
    }

    /// <summary>Also at the image's border, where samples lie outside the pixels' centres.</summary>
    [Theory]
    [MemberData(nameof(Lenses))]
    public void Render_Lens_IsTheMeanOfItsSamples(string name)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("oblique-20km");
        Compare(
            _renderer, scene, LensCases.Of(name, 0.4, 41, 30), scene.Camera(rugged.Grid, 30, 41).State, 2 + (name.Length % 2), Options);
    }

    [Theory]
    [InlineData("akimov", SunModel.Point)]
    [InlineData("hapke", SunModel.Point)]
    [InlineData("lambert", SunModel.Disc)]
    public void Render_LawAndSun_IsTheMeanOfItsSamples(string law, SunModel sun)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("nadir-100km");
        CameraModel model = new(50, 40, (25.0 / NarrowTangent, 25.0 / NarrowTangent), (25.0, 20.0));
        Compare(
            _renderer, scene, model, scene.Camera(rugged.Grid, 50, 40).State, 3,
            Options with { Reflectance = ReflectanceFactory.Create(law, new Dictionary<string, double>()), Sun = sun });
    }

    /// <summary>
    /// Samples on a facet share the smooth normal at their mean place, and the mean incidence angle of what they see of the Sun's disc: not
    /// the mean of their brightness, but no farther from the truth.
    /// </summary>
    [Theory]
    [InlineData("nadir-100km", 3, NormalModel.Smooth, SunModel.Point, OfError)]
    [InlineData("south-pole", 2, NormalModel.Smooth, SunModel.Point, OfError)]
    [InlineData("grazing-sun", 3, NormalModel.Smooth, SunModel.Disc, OfErrorAtTerminator)]
    [InlineData("grazing-sun", 3, NormalModel.Facet, SunModel.Disc, OfError)]
    public void Render_SharedBrightness_IsAsNearToManySamplesAsTheMeanOfItsSamples(
        string name, int perAxis, NormalModel normals, SunModel disc, double allowed)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        CameraModel model = new(60, 60, (60.0, 60.0), (30.5, 30.5));
        CameraState state = scene.Camera(rugged.Grid, 60, 60).State;
        SceneLight sun = new(scene.Sun, IsSun: true);
        NativeRenderOptions options = Options with
        {
            Normals = normals,
            Sun = disc,
            Reflectance = ReflectanceFactory.Create("moon", new Dictionary<string, double>()),
        };
        double[] truth = MeanOfSamples(_renderer, model, state, 8, sun, options);
        double[] loop = MeanOfSamples(_renderer, model, state, perAxis, sun, options);
        using NativeFrame frame = _renderer.Render(model.At(state), sun, options with { SubsamplesPerAxis = perAxis }, threads: 2);

        double ErrorOf(double[] factors) => Math.Sqrt(truth.Zip(factors, (a, b) => (a - b) * (a - b)).Average());
        Assert.InRange(ErrorOf(frame.RadianceFactors.ToArray()), 1e-9, allowed * ErrorOf(loop));
    }

    /// <summary>
    /// Where the pixels of a map are not much larger than the image's, each sample reads it. Truth and loop are images of so many times the
    /// width and height, as a single sample reads as much of the map as its pixel covers.
    /// </summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void Render_FineMap_IsAsNearToManySamplesAsTheMeanOfItsSamples(int perAxis)
    {
        const int Size = 60;
        Random random = new(20120222);
        NativeRenderOptions options = Options with
        {
            Albedo = SyntheticMaps.Of(1440, (_, _) => 500 + random.Next(1000)),
        };
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("far");
        SceneLight sun = new(scene.Sun, IsSun: true);
        double[] Fine(int across)
        {
            using NativeFrame frame = _renderer.Render(scene.Camera(rugged.Grid, across * Size, across * Size), sun, options, threads: 2);
            double[] means = new double[Size * Size];
            for (int pixel = 0; pixel < frame.RadianceFactors.Length; pixel++)
            {
                (int row, int column) = Math.DivRem(pixel, across * Size);
                means[(row / across * Size) + (column / across)] += frame.RadianceFactors[pixel] / (across * across);
            }

            return means;
        }

        double[] truth = Fine(8);
        using NativeFrame frame = _renderer.Render(
            scene.Camera(rugged.Grid, Size, Size), sun, options with { SubsamplesPerAxis = perAxis }, threads: 2);

        double ErrorOf(double[] factors) => Math.Sqrt(truth.Zip(factors, (a, b) => (a - b) * (a - b)).Average());
        Assert.InRange(ErrorOf(frame.RadianceFactors.ToArray()), 1e-9, OfError * ErrorOf(Fine(perAxis)));
    }

    [Fact]
    public void Render_NothingButSky_IsBlack()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("half-sky") with { Tilt = 170.0 };
        using NativeFrame frame = _renderer.Render(
            scene.Camera(rugged.Grid, 20, 20), new SceneLight(scene.Sun, IsSun: true), Options with { SubsamplesPerAxis = 3 }, threads: 1);

        Assert.All(frame.RadianceFactors.ToArray(), factor => Assert.Equal(0.0, factor));
    }

    private static void Compare(
        NativeRenderer renderer, RenderScenes.RenderSceneCase scene, CameraModel model, CameraState state, int perAxis,
        NativeRenderOptions options)
    {
        SceneLight sun = new(scene.Sun, IsSun: true);
        double[] expected = MeanOfSamples(renderer, model, state, perAxis, sun, options);

        using NativeFrame frame = renderer.Render(model.At(state), sun, options with { SubsamplesPerAxis = perAxis }, threads: 2);

        Assert.InRange(expected.Max(), 1e-3, 1.0);
        Assert.All(
            expected.Zip(frame.RadianceFactors.ToArray()),
            pixel => Assert.InRange(pixel.Second, (1.0 - OfBrightness) * pixel.First, (1.0 + OfBrightness) * pixel.First));
    }

    /// <summary>The loop over whole images: each has the principal point shifted the other way than its samples.</summary>
    private static double[] MeanOfSamples(
        NativeRenderer renderer, CameraModel model, CameraState state, int perAxis, SceneLight sun, NativeRenderOptions options)
    {
        double[] sums = new double[model.Width * model.Height];
        for (int sample = 0; sample < perAxis * perAxis; sample++)
        {
            double right = (((sample % perAxis) + 0.5) / perAxis) - 0.5;
            double down = (((sample / perAxis) + 0.5) / perAxis) - 0.5;
            using NativeFrame frame = renderer.Render(ShiftedCamera.Of(model.At(state), right, down), sun, options, threads: 2);
            for (int pixel = 0; pixel < sums.Length; pixel++)
            {
                sums[pixel] += frame.RadianceFactors[pixel] / (perAxis * perAxis);
            }
        }

        return sums;
    }
}
