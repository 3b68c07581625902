using Msisf.Core.Camera;
using Msisf.Core.Certainty;
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

/// <summary>Bounds against images of changed ground, seen from changed cameras in changed light.</summary>
public sealed class CertainPixelsTests(RuggedTerrain rugged, ITestOutputHelper output) : IClassFixture<RuggedTerrain>
{
    private const int Size = 64;

    private static readonly Uncertainty Limits = new(Height: 20.0, Position: 30.0, Turn: 2e-4, Sun: 1e-3);

    private static readonly NativeRenderOptions Moon = new() { Reflectance = ReflectanceFactory.Create("moon", new Dictionary<string, double>()) };

    public static TheoryData<string> Scenes => ["nadir-100km", "oblique-20km", "grazing-sun", "limb", "inside-crater"];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Find_Moon_HoldsAllImagesWithinTheLimits(string scene) => Compare(scene, Moon);

    private void Compare(string name, NativeRenderOptions options)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        FrameCamera camera = scene.Camera(rugged.Grid, Size, Size);
        SceneLight light = new(scene.Sun, IsSun: true);
        System.Diagnostics.Stopwatch watch = System.Diagnostics.Stopwatch.StartNew();
        CertainImage certain = new CertainPixels(rugged.Grid, options, Limits).Find(camera, light, 2, CancellationToken.None);
        output.WriteLine($"{watch.Elapsed} to find");
        watch.Restart();
        (double[] least, double[] greatest) = ([.. Enumerable.Repeat(double.PositiveInfinity, Size * Size)], new double[Size * Size]);
        RendererMemory memory = new();
        Random random = new(51);
        int images = TestLength.Of(40, 2000);
        int outside = 0;
        double worst = 0.0;
        int wrong = 0;
        for (int image = 0; image < images; image++)
        {
            NativeRenderer renderer = new(new ChangedGround(rugged.Grid, Limits.Height, (ulong)random.NextInt64()), memory);
            CameraState state = camera.State with
            {
                PositionBodyFixed = camera.PositionBodyFixed + (Limits.Position * InBall(random)),
                MoonFromCamera = Turned(camera.MoonFromCamera, InBall(random)),
            };
            Vector3D about = Vector3D.Cross(light.PositionBodyFixed, InBall(random)).Normalized();
            SceneLight sun = light with
            {
                PositionBodyFixed = UnitQuaternion.FromAxisAngle(about, Limits.Sun * Part(random)) * light.PositionBodyFixed,
            };
            using NativeFrame frame = renderer.Render(camera.Model.At(state), sun, options with { KeepGroundTruth = true }, 2);
            for (int pixel = 0; pixel < Size * Size; pixel++)
            {
                double factor = frame.RadianceFactors[pixel];
                least[pixel] = Math.Min(least[pixel], factor);
                greatest[pixel] = Math.Max(greatest[pixel], factor);
                if (factor < certain.Low[pixel] || factor > certain.High[pixel])
                {
                    outside++;
                    worst = Math.Max(worst, Math.Max(certain.Low[pixel] - factor, factor - certain.High[pixel]));
                }

                bool isGround = frame.TryGet((pixel % Size) + 1, (pixel / Size) + 1, out SurfaceHit _, out PixelIllumination seen);
                bool isRight = certain.States[pixel] switch
                {
                    CertainState.NoSurface => !isGround,
                    CertainState.Lit => isGround && seen.State == IlluminationState.Lit,
                    CertainState.Dark => isGround && seen.VisibleFraction == 0.0,
                    _ => true,
                };
                wrong += isRight ? 0 : 1;
            }
        }

        double[] ratios = [.. Enumerable.Range(0, Size * Size).Where(i => greatest[i] > least[i])
            .Select(i => (certain.High[i] - certain.Low[i]) / (greatest[i] - least[i])).Order()];
        output.WriteLine(
            $"{name}: {outside} outside, by up to {worst:G3}, {wrong} wrong; widths {ratios[ratios.Length / 10]:F2} {ratios[ratios.Length / 2]:F2} {ratios[ratios.Length * 9 / 10]:F2}; "
            + string.Join(", ", certain.States.GroupBy(s => s).Select(g => $"{g.Key} {g.Count()}")) + $" {watch.Elapsed}");
        Assert.Equal(0, outside);
        Assert.Equal(0, wrong);
    }

    private static UnitQuaternion Turned(UnitQuaternion moonFromCamera, Vector3D turn) =>
        moonFromCamera * UnitQuaternion.FromAxisAngle(turn.Normalized(), Limits.Turn * turn.Length);

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
