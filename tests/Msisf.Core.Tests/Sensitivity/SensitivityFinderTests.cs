using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Sensitivity;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Core.Tests.Sensitivity;

public sealed class SensitivityFinderTests(RuggedTerrain rugged, ITestOutputHelper output) : IClassFixture<RuggedTerrain>
{
    private const int Size = 64;

    /// <summary>px: sides of the squares whose sums are compared at edges, where single pixels are off by a half.</summary>
    private const int Block = 8;

    /// <summary>
    /// Of the layer's rms, in pixels without edges: 0.0015, but 0.019 for motion along the line of sight in the crater, where the nearest
    /// ground is 50 m away.
    /// </summary>
    private const double OfSmooth = 0.02;

    /// <summary>
    /// Of the rms of sums over squares: samples place an edge on a square's border to a twentieth of a pixel, and the differences are off
    /// by up to 0.02 themselves. 0.005 to 0.06 were found, but up to 0.16 at the limb and in the crater for motion along the edges.
    /// </summary>
    private const double OfSums = 0.2;

    /// <summary>The same for shadows: where facets are narrow and seen obliquely, which one casts a border is not known.</summary>
    private const double OfShadows = 0.1;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LunarLambertReflectance(0.12, 0.6) };

    public static TheoryData<string> Scenes => ["nadir-100km", "oblique-20km", "grazing-sun", "limb", "inside-crater"];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Find_Scene_IsTheDifferenceOfShiftedDrawings(string name)
    {
        string[] everyDay = ["position-y", "turn-y", "sun-east"];
        Compare(
            name, Options, camera => camera, TestLength.Of(2, 4),
            [.. Parameter.All.Where(p => p.Kind != ParameterKind.Albedo && (TestLength.IsLong || everyDay.Contains(p.Name)))]);
    }

    [Theory]
    [InlineData("nadir-100km")]
    [InlineData("limb")]
    public void Find_SmoothGroundUnderTheDisc_IsTheDifferenceOfShiftedDrawings(string name) => Compare(
        name, Options with { Normals = NormalModel.Smooth, Sun = SunModel.Disc }, camera => camera, 2, Named("turn-x", "position-z"));

    [Theory]
    [InlineData("oblique-20km", "brown")]
    public void Find_Lens_IsTheDifferenceOfShiftedDrawings(string name, string lens) => Compare(
        name, Options, camera => LensCases.Of(lens, 0.3, Size, Size).At(camera.State), 2,
        Named("turn-y", "focal-length"));

    [Fact]
    public void Find_LampAtTheCamera_IsRefused()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("limb");
        FrameCamera camera = scene.Camera(rugged.Grid, 8, 8);
        SensitivityFinder finder = new(new NativeRenderer(rugged.Grid), new TerrainTracer(rugged.Grid), Options);

        BadInputException refused = Assert.Throws<BadInputException>(
            () => finder.Find(camera, new SceneLight(camera.PositionBodyFixed, IsSun: false), 1, CancellationToken.None));

        Assert.Contains("--ignore-sun", refused.Message);
    }

    [Fact]
    public void Find_MoreThreads_HasTheSameBits()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("grazing-sun");
        FrameCamera camera = scene.Camera(rugged.Grid, Size, Size);
        SensitivityFinder finder = new(new NativeRenderer(rugged.Grid), new TerrainTracer(rugged.Grid), Options);
        SceneLight light = new(scene.Sun, IsSun: true);

        SensitivityField one = finder.Find(camera, light, 1, CancellationToken.None);
        SensitivityField two = finder.Find(camera, light, 2, CancellationToken.None);

        Assert.All(Parameter.All, parameter => Assert.Equal(one.Of(parameter), two.Of(parameter)));
    }

    private static IReadOnlyList<Parameter> Named(params string[] names) => [.. Parameter.All.Where(p => names.Contains(p.Name))];

    private void Compare(
        string name, NativeRenderOptions options, Func<FrameCamera, FrameCamera> change, int pieces, IReadOnlyList<Parameter> parameters)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        NativeRenderer renderer = new(rugged.Grid);
        FrameCamera camera = change(scene.Camera(rugged.Grid, Size, Size));
        SceneLight light = new(scene.Sun, IsSun: true);
        SensitivityField field = new SensitivityFinder(renderer, new TerrainTracer(rugged.Grid), options)
            .Find(camera, light, 2, CancellationToken.None);
        DifferencedImages differences = new(renderer, camera, light, options, pieces);
        using NativeFrame frame = renderer.Render(camera, light, options with { KeepGroundTruth = true }, 2);
        bool[] isSmooth = FindSmooth(frame);
        foreach (Parameter parameter in parameters)
        {
            double speed = parameter.Kind switch
            {
                ParameterKind.Position => camera.Model.FocalX / NearestDepth(frame),
                ParameterKind.Turn or ParameterKind.Sun => camera.Model.FocalX,
                ParameterKind.FocalLength => 0.5 * Size / camera.Model.FocalX,
                _ => 1.0,
            };
            double[] found = field.Of(parameter);
            double[] expected = differences.WithEdges(parameter, speed);
            double[] smooth = differences.WithoutEdges(parameter, speed);
            double ofSmooth = Rms(found.Zip(smooth, (f, e) => f - e).Where((_, i) => isSmooth[i])) / Rms(expected);
            double[] sums = Sums(expected);
            double ofSums = Rms(Sums(found).Zip(sums, (f, e) => f - e)) / Rms(sums);
            output.WriteLine($"{name} {parameter}: {ofSmooth:F5} in {isSmooth.Count(s => s)} pixels without edges, {ofSums:F4} of sums");

            Assert.True(ofSmooth <= OfSmooth, $"{parameter}: off by {ofSmooth} in pixels without edges");
            double tolerance = parameter.Kind == ParameterKind.Sun ? OfShadows : OfSums;
            Assert.True(ofSums <= tolerance, $"{parameter}: sums are off by {ofSums}");
        }
    }

    private static double NearestDepth(NativeFrame frame)
    {
        double nearest = double.PositiveInfinity;
        for (int pixel = 0; pixel < Size * Size; pixel++)
        {
            if (frame.TryGet((pixel % Size) + 1, (pixel / Size) + 1, out SurfaceHit hit, out _))
            {
                nearest = Math.Min(nearest, hit.RayParameter * ((FrameCamera)frame.Camera).ImagePlaneDistance);
            }
        }

        return nearest;
    }

    /// <summary>Pixels that show the same facet in the same light as all their neighbours.</summary>
    private static bool[] FindSmooth(NativeFrame frame)
    {
        bool[] isSmooth = new bool[Size * Size];
        for (int y = 2; y < Size; y++)
        {
            for (int x = 2; x < Size; x++)
            {
                bool isSame = frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light);
                for (int k = 0; k < 9 && isSame; k++)
                {
                    isSame = frame.TryGet(x - 1 + (k % 3), y - 1 + (k / 3), out SurfaceHit next, out PixelIllumination other)
                        && next.Facet == hit.Facet && other.State == light.State;
                }

                isSmooth[((y - 1) * Size) + x - 1] = isSame;
            }
        }

        return isSmooth;
    }

    private static double[] Sums(double[] image)
    {
        const int Across = Size / Block;
        double[] sums = new double[Across * Across];
        for (int i = 0; i < image.Length; i++)
        {
            sums[(i / Size / Block * Across) + (i % Size / Block)] += image[i];
        }

        return sums;
    }

    private static double Rms(IEnumerable<double> values)
    {
        (double sum, int count) = (0.0, 0);
        foreach (double value in values)
        {
            sum += value * value;
            count++;
        }

        return Math.Sqrt(sum / Math.Max(1, count));
    }
}
