using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Render.Photometry;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>
/// Images whose rows fill no whole vectors, down to one pixel: nothing behind a row counts, neither what an image before has left there nor
/// what lies behind an array, which debug builds refuse to read.
/// </summary>
public sealed class NativeRendererSizeTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private const int Most = 67;

    private const double Tangent = 0.4;

    private static readonly Dictionary<string, double> NoParameters = [];

    private static readonly NativeRenderOptions Plain = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    private static readonly NativeRenderOptions OfMoon = Plain with { Reflectance = ReflectanceFactory.Create("moon", NoParameters) };

    private static readonly (string Name, NativeRenderOptions Options)[] Kinds =
    [
        ("plain", Plain),
        ("grid", Plain with { SubsamplesPerAxis = 3 }),
        ("disc", Plain with { Sun = SunModel.Disc }),
        ("smooth", Plain with { Reflectance = ReflectanceFactory.Create("hapke", NoParameters), Normals = NormalModel.Smooth }),
        ("map", OfMoon with { Albedo = SyntheticMaps.Of(360, (column, row) => 800 + (100 * ((column + row) % 3))) }),
        ("adaptive", OfMoon with { Adaptive = new AdaptiveSampling(0.4, new GreyScale()) }),
    ];

    private readonly NativeRenderer _used = new(rugged.Grid);

    public static TheoryData<string, string> Cases
    {
        get
        {
            TheoryData<string, string> cases = [];
            foreach ((string kind, _) in Kinds)
            {
                cases.Add("limb", kind);
                cases.Add("oblique-20km", kind);
            }

            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Render_AnySize_IsTheSameAsAfterALargerImage(string scene, string kind)
    {
        NativeRenderOptions options = Kinds.Single(each => each.Name == kind).Options;
        foreach (bool hasLens in (bool[])[false, true])
        {
            _ = FrameOf(_used, scene, hasLens, Most, Most, options);
            for (int width = 1; width <= Most; width += TestLength.Of(width < 10 ? 1 : 6, 1))
            {
                int height = 1 + (width % Math.Min(width, 3)); // a higher image would be too much for the lens
                Assert.Equal(
                    FrameOf(new NativeRenderer(rugged.Grid), scene, hasLens, width, height, options),
                    FrameOf(_used, scene, hasLens, width, height, options));
            }
        }
    }

    [Fact]
    public void SampleRow_AnySize_IsTheSameFromTheTopAndFromTheBottom()
    {
        const int Height = 3;
        for (int width = 1; width <= Most; width += TestLength.Of(width < 10 ? 1 : 6, 1))
        {
            (FrameCamera camera, SceneLight sun) = SceneOf("limb", hasLens: width > Height && width % 2 == 0, width, Height);
            using NativeFrame frame = _used.Render(camera, sun, Plain, threads: 1);
            Assert.Equal(
                LayersOf(frame, Enumerable.Range(0, Height)), LayersOf(frame, Enumerable.Range(0, Height).Reverse()));
        }
    }

    private static double[][] LayersOf(NativeFrame frame, IEnumerable<int> rows)
    {
        IReadOnlyList<Layer> layers = LayerSet.OfAnyFrame.Layers;
        LayerSampler sampler = new(frame, new LayerProvenance("RUGGED_4", 4, 0, "native", SpectralBand.Default));
        double[][] planes =
            [.. Enumerable.Range(0, layers.Sum(layer => layer.Planes)).Select(_ => new double[frame.Camera.Width * frame.Camera.Height])];
        foreach (int row in rows)
        {
            sampler.SampleRow(row, layers, planes, row * frame.Camera.Width);
        }

        return planes;
    }

    private FrameValues FrameOf(NativeRenderer renderer, string scene, bool hasLens, int width, int height, NativeRenderOptions options)
    {
        (FrameCamera camera, SceneLight sun) = SceneOf(scene, hasLens, width, height);
        return FrameValues.Of(renderer, camera, sun, options, threads: 1);
    }

    private (FrameCamera Camera, SceneLight Sun) SceneOf(string name, bool hasLens, int width, int height)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        PinholeCamera pinhole = scene.Camera(rugged.Grid, width, height);
        FrameCamera camera = hasLens ? LensCases.Of("barrel", Tangent, width, height).At(pinhole.State) : pinhole;
        return (camera, new SceneLight(scene.Sun, IsSun: true));
    }
}
