using Msisf.Core.Camera;
using Msisf.Core.Certainty;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Core.Tests.Certainty;

/// <summary>
/// Bounds against images of changed ground, seen from changed cameras in changed light: half of the changes are as large as allowed.
/// </summary>
public sealed class CertainPixelsTests(RuggedTerrain rugged, ITestOutputHelper output) : IClassFixture<RuggedTerrain>
{
    private const int Size = 64;

    /// <summary>Of the range that the images have; what the median of the pixels may be wider.</summary>
    private const double WidestMedian = 3.0;

    private static readonly Uncertainty FromAfar = new(Height: 20.0, Position: 30.0, Turn: 2e-4, Sun: 1e-3);

    /// <summary>From 50 m over the ground, 20 m are nearly everything.</summary>
    private static readonly Uncertainty FromNear = new(Height: 0.25, Position: 0.2, Turn: 2e-4, Sun: 1e-3);

    private static readonly NativeRenderOptions Moon = new()
    {
        Reflectance = ReflectanceFactory.Create("moon", new Dictionary<string, double>()),
    };

    public static TheoryData<string> Scenes => ["nadir-100km", "oblique-20km", "grazing-sun", "limb", "inside-crater"];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Find_Moon_HoldsAllImagesWithinTheLimits(string scene) => Assert.InRange(
        Compare(scene, Moon, scene == "inside-crater" ? FromNear : FromAfar, TestLength.Of(40, 2_000)), 1.0, WidestMedian);

    [Theory]
    [InlineData("grazing-sun", SunModel.Disc, 1)]
    [InlineData("limb", SunModel.Point, 2)]
    public void Find_OtherLaws_HoldsAllImagesWithinTheLimits(string scene, SunModel sun, int samples) => Compare(
        scene,
        new NativeRenderOptions
        {
            Reflectance = sun == SunModel.Disc ? new LambertReflectance(0.5) : new LunarLambertReflectance(0.12),
            Sun = sun,
            SubsamplesPerAxis = samples,
        },
        FromAfar,
        TestLength.Of(8, 500));

    /// <summary>From near a sample is smaller than the map's pixels, from afar larger.</summary>
    [Theory]
    [InlineData("nadir-100km")]
    [InlineData("wide-angle")]
    public void Find_Map_HoldsAllImagesWithinTheLimits(string scene) =>
        Compare(scene, Moon with { Albedo = RandomMap() }, FromAfar, TestLength.Of(8, 500));

    [Fact]
    public void Find_NoLimits_IsTheImage()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("oblique-20km");
        FrameCamera camera = scene.Camera(rugged.Grid, Size, Size);
        SceneLight light = new(scene.Sun, IsSun: true);
        using NativeFrame frame = new NativeRenderer(rugged.Grid).Render(camera, light, Moon, 2);

        CertainImage certain = new CertainPixels(rugged.Grid, Moon, new Uncertainty(0.0, 0.0, 0.0, 0.0))
            .Find(camera, light, 1, CancellationToken.None);

        // What is left is the lattice of the corners: 16 mm.
        double[] widths = [.. certain.High.Zip(certain.Low, (high, low) => high - low).Order()];
        Assert.InRange(widths[Size * Size * 9 / 10], 0.0, 1e-3);
        Assert.InRange(certain.States.Count(state => state == CertainState.Undecided), 0, Size * Size / 20);
    }

    [Fact]
    public void Find_MoreThreads_HasTheSameBits()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("limb");
        FrameCamera camera = scene.Camera(rugged.Grid, 24, 24);
        CertainPixels pixels = new(rugged.Grid, Moon, FromAfar);
        SceneLight light = new(scene.Sun, IsSun: true);

        CertainImage one = pixels.Find(camera, light, 1, CancellationToken.None);
        CertainImage two = pixels.Find(camera, light, 2, CancellationToken.None);

        Assert.Equal(one.Low, two.Low);
        Assert.Equal(one.High, two.High);
        Assert.Equal(one.States, two.States);
    }

    [Fact]
    public void Find_SmoothGround_IsRefused()
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("limb");
        FrameCamera camera = scene.Camera(rugged.Grid, 8, 8);

        BadInputException refused = Assert.Throws<BadInputException>(
            () => new CertainPixels(rugged.Grid, Moon with { Normals = NormalModel.Smooth }, FromAfar)
                .Find(camera, new SceneLight(scene.Sun, IsSun: true), 1, CancellationToken.None));

        Assert.Contains("--shading facet", refused.Message);
    }

    /// <returns>By what the bounds are wider than the images' range, in the median of the pixels.</returns>
    private double Compare(string name, NativeRenderOptions options, Uncertainty limits, int images)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        FrameCamera camera = scene.Camera(rugged.Grid, Size, Size);
        SceneLight light = new(scene.Sun, IsSun: true);
        CertainImage certain = new CertainPixels(rugged.Grid, options, limits).Find(camera, light, 2, CancellationToken.None);
        (double[] least, double[] greatest) = ([.. Enumerable.Repeat(double.PositiveInfinity, Size * Size)], new double[Size * Size]);
        RendererMemory memory = new();
        Random random = new(51);
        for (int image = 0; image < images; image++)
        {
            NativeRenderer renderer = new(new ChangedGround(rugged.Grid, limits.Height, (ulong)random.NextInt64()), memory);
            CameraState pose = camera.State with
            {
                PositionBodyFixed = camera.PositionBodyFixed + (limits.Position * InBall(random)),
                MoonFromCamera = Turned(camera.MoonFromCamera, limits.Turn * InBall(random)),
            };
            Vector3D about = Vector3D.Cross(light.PositionBodyFixed, InBall(random)).Normalized();
            SceneLight sun = light with
            {
                PositionBodyFixed = UnitQuaternion.FromAxisAngle(about, limits.Sun * Part(random)) * light.PositionBodyFixed,
            };
            using NativeFrame frame = renderer.Render(camera.Model.At(pose), sun, options with { KeepGroundTruth = true }, 2);
            for (int pixel = 0; pixel < Size * Size; pixel++)
            {
                double factor = frame.RadianceFactors[pixel];
                (least[pixel], greatest[pixel]) = (Math.Min(least[pixel], factor), Math.Max(greatest[pixel], factor));
                string what = $"{name}, image {image}, pixel {pixel}: {factor} of {certain.Low[pixel]} to {certain.High[pixel]}";
                Assert.True(factor >= certain.Low[pixel] && factor <= certain.High[pixel], what);
                CertainState state = certain.States[pixel];
                Assert.True(IsRight(frame, pixel, state, options.SubsamplesPerAxis == 1), $"{what}, {state}");
            }
        }

        double[] ratios = [.. Enumerable.Range(0, Size * Size).Where(i => greatest[i] > least[i])
            .Select(i => (certain.High[i] - certain.Low[i]) / (greatest[i] - least[i])).Order()];
        output.WriteLine(
            $"{name}: {images} images; width over their range {ratios[ratios.Length / 10]:F2}, {ratios[ratios.Length / 2]:F2}, "
                + $"{ratios[ratios.Length * 9 / 10]:F2}; "
                + string.Join(", ", certain.States.GroupBy(s => s).OrderBy(g => g.Key).Select(g => $"{g.Key} {g.Count()}")));
        return ratios[ratios.Length / 2];
    }

    /// <param name="isCentre">Whether the pixel's sample is its centre, of which the truth tells.</param>
    private static bool IsRight(NativeFrame frame, int pixel, CertainState state, bool isCentre)
    {
        bool isGround = frame.TryGet((pixel % Size) + 1, (pixel / Size) + 1, out SurfaceHit _, out PixelIllumination light);
        bool isLight = frame.RadianceFactors[pixel] > 0.0;
        return state switch
        {
            CertainState.Lit => isLight && (!isCentre || light.State == IlluminationState.Lit),
            CertainState.Dark => !isLight && (!isCentre || (isGround && light.VisibleFraction == 0.0)),
            CertainState.NoSurface => !isLight && !(isCentre && isGround),
            _ => true,
        };
    }

    /// <summary>Levels of random pixels, each the mean of four.</summary>
    private static AlbedoMap RandomMap()
    {
        (int width, int height) = (1024, 512);
        Random random = new(7);
        ushort[] codes = [.. Enumerable.Range(0, width * height).Select(_ => (ushort)random.Next(10_000, 60_000))];
        List<AlbedoMapLevel> levels = [new AlbedoMapLevel(width, height, codes)];
        while (height > 1)
        {
            ushort[] finer = codes;
            int stride = width;
            (width, height) = (width / 2, height / 2);
            codes = [.. Enumerable.Range(0, width * height).Select(i => ((i / width * 2 * stride) + (i % width * 2)) is var first
                ? (ushort)((finer[first] + finer[first + 1] + finer[first + stride] + finer[first + stride + 1]) / 4)
                : default)];
            levels.Add(new AlbedoMapLevel(width, height, codes));
        }

        return new AlbedoMap(levels, MapExtent.WholeMoon, 0.0, 1e-6, new ReferenceGeometry(30.0, 0.0, 30.0));
    }

    private static UnitQuaternion Turned(UnitQuaternion moonFromCamera, Vector3D turn) =>
        moonFromCamera * UnitQuaternion.FromAxisAngle(turn.Normalized(), turn.Length);

    private static double Part(Random random) => random.Next(2) == 0 ? random.NextDouble() : 1.0;

    private static Vector3D InBall(Random random)
    {
        Vector3D point;
        do
        {
            point = new Vector3D((2.0 * random.NextDouble()) - 1.0, (2.0 * random.NextDouble()) - 1.0, (2.0 * random.NextDouble()) - 1.0);
        }
        while (point.LengthSquared > 1.0);

        return random.Next(2) == 0 ? point : point.Normalized();
    }
}
