using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>
/// Scans by cameras that tumble at 0.1 rad/s, shake and fly at 1.6 km/s over several models under a Sun 2 degrees high: each pixel is what
/// the
/// exact tracer finds with the state of its row.
/// </summary>
public sealed class ScannedSceneTests
{
    private const int Width = 40;

    /// <summary>m: as for frames of one state (<see cref="NativeRendererSceneTests"/>).</summary>
    private const double SamePoint = 1e-7;

    [Theory]
    [InlineData("gaps", ScanKind.LineScan, "barrel")]
    [InlineData("gaps", ScanKind.PushFrame, "principal-point")]
    [InlineData("gaps", ScanKind.RollingShutter, "fisheye")]
    public void Render_TumblingScan_IsAsTracedWithTheStateOfEachRow(string models, ScanKind kind, string lens)
    {
        int count = TestLength.Of(24, 1000);
        int height = kind == ScanKind.LineScan ? 1 : kind == ScanKind.PushFrame ? 4 : count;
        CameraModel model = LensCases.Of(lens, 0.4 * Math.Min(1.0, (double)Width / height), Width, height);
        NestedTerrain terrain = NestedScenes.Named(models);
        TerrainTracer tracer = new(terrain);
        Vector3D up = -Vector3D.UnitZ;
        CameraState start = new((terrain.GroundRadius(up) + 15_000.0) * up, LookDown);
        CameraMotion motion = new(new Vector3D(1500.0, 550.0, -300.0), 0.1 * new Vector3D(0.6, -0.5, 0.62).Normalized());
        Jitter jitter = new([new JitterSine(JitterAxis.Pitch, 31.0, 3e-3, 0.2), new JitterSine(JitterAxis.Roll, 77.0, 2e-3, 1.0)]);
        Scan scan = new(kind, count, 2.0 / count);
        Vector3D sun = SunAt(0.0);
        SceneLight light = new(sun, IsSun: true);
        ScanPath path = new ScanPath(seconds => motion.Moved(start, seconds)).Of(scan, jitter, 0.0);
        ICamera camera = scan.CameraOf(model, [.. path.States.Select(state => state with { SunPositionBodyFixed = SunAt(state.Seconds) })]);
        NativeRenderOptions options = new() { KeepGroundTruth = true, Reflectance = new LambertReflectance(0.6) };
        using NativeFrame drawn = new NativeRenderer(terrain).Render(camera, light, options, threads: 2);

        int hits = 0;
        int dark = 0;
        for (int y = 1; y <= camera.Height; y++)
        {
            int exposure = kind == ScanKind.PushFrame ? (y - 1) / 4 : y - 1;
            double seconds = exposure * (2.0 / count);
            CameraState state = motion.Moved(start, seconds);
            state = state with { MoonFromCamera = jitter.Turn(state.MoonFromCamera, seconds) };
            FrameCamera still = model.At(state);
            double row = kind == ScanKind.RollingShutter ? y : kind == ScanKind.LineScan ? 1 : ((y - 1) % 4) + 1;
            for (int x = 1; x <= Width; x++)
            {
                bool isHit = tracer.TryTrace(still.RayThrough(x, row), out SurfaceHit expected);
                Assert.Equal(isHit, drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination seen));
                if (isHit)
                {
                    Assert.Equal(expected.Facet, hit.Facet);
                    Assert.InRange((hit.PointBodyFixed - expected.PointBodyFixed).Length, 0.0, SamePoint);
                    bool isDark = tracer.IsHidden(expected.PointBodyFixed, expected.Facet, SunAt(seconds));
                    SceneLight there = light with { PositionBodyFixed = SunAt(seconds) };
                    Assert.Equal(PixelIllumination.At(hit.PointBodyFixed, isDark ? 0.0 : 1.0, there), seen);
                    hits++;
                    dark += isDark ? 1 : 0;
                }
            }
        }

        Assert.InRange(hits, Width * camera.Height / 3, Width * camera.Height);
        Assert.InRange(dark, hits / 20, hits - (hits / 20));
    }

    /// <summary>A scan of equal states is the frame of as many rows, each the same as the frame's one row.</summary>
    [Fact]
    public void Render_EqualStates_IsTheFrameToTheBit()
    {
        CameraModel model = LensCases.Of("barrel", 0.4, Width, 12);
        NestedTerrain terrain = NestedScenes.Named("five");
        CameraState state = new((terrain.GroundRadius(-Vector3D.UnitZ) + 15_000.0) * -Vector3D.UnitZ, LookDown);
        NativeRenderOptions options = new() { Reflectance = new LambertReflectance(0.6) };
        SceneLight light = new(SunAt(0.0), IsSun: true);
        NativeRenderer renderer = new(terrain);
        using NativeFrame frame = renderer.Render(model.At(state), light, options, threads: 2);
        ICamera camera = new Scan(ScanKind.RollingShutter, 12, 1.0).CameraOf(
            model, [.. Enumerable.Range(0, 12).Select(row => state with { Seconds = row, SunPositionBodyFixed = SunAt(0.0) })]);
        Assert.Equal(12, camera.Bands.Count);
        using NativeFrame scanned = renderer.Render(camera, light, options, threads: 2);

        Assert.Equal(frame.RadianceFactors.ToArray(), scanned.RadianceFactors.ToArray());
    }

    /// <summary>Strips that are drawn when they are asked for show what the whole image shows.</summary>
    [Fact]
    public void StripedTruth_AllRows_IsThatOfTheWholeImage()
    {
        CameraModel model = LensCases.Of("barrel", 0.4, Width, 2);
        NestedTerrain terrain = NestedScenes.Named("gaps");
        CameraState start = new((terrain.GroundRadius(-Vector3D.UnitZ) + 15_000.0) * -Vector3D.UnitZ, LookDown);
        CameraMotion motion = new(new Vector3D(1500.0, 550.0, -300.0), new Vector3D(0.05, 0.08, -0.04));
        Scan scan = new(ScanKind.PushFrame, 11, 0.1);
        ScanPath path = new ScanPath(seconds => motion.Moved(start, seconds)).Of(scan, null, 0.0);
        ICamera camera = scan.CameraOf(model, [.. path.States.Select(state => state with { SunPositionBodyFixed = SunAt(state.Seconds) })]);
        NativeRenderOptions options = new() { KeepGroundTruth = true, Reflectance = new LambertReflectance(0.6) };
        SceneLight light = new(SunAt(0.0), IsSun: true);
        NativeRenderer renderer = new(terrain);
        using NativeFrame whole = renderer.Render(camera, light, options, threads: 2);
        List<PixelRows> asked = [];
        StripedTruth striped = new(camera, light, rowsOfStrip: 6, rowsOfExposure: 2, rows =>
        {
            asked.Add(rows);
            return renderer.RenderRows(camera, light, rows, options, 2, default);
        });

        AssertRow(9);
        Assert.Equal([new PixelRows(8, 10)], asked);
        for (int y = 1; y <= 22; y++)
        {
            Assert.Equal(
                whole.RadianceFactors.Slice((y - 1) * Width, Width).ToArray(), ((IGroundTruth)striped).RadianceFactorsOf(y - 1).ToArray());
            AssertRow(y);
        }

        Assert.Equal([new PixelRows(8, 10), new(0, 6), new(6, 12), new(12, 18), new(18, 22)], asked);

        void AssertRow(int y)
        {
            for (int x = 1; x <= Width; x++)
            {
                Assert.Equal(
                    whole.TryGet(x, y, out SurfaceHit expected, out PixelIllumination lit),
                    striped.TryGet(x, y, out SurfaceHit hit, out PixelIllumination seen));
                Assert.Equal((expected, lit), (hit, seen));
            }
        }
    }

    private static UnitQuaternion LookDown => UnitQuaternion.FromAxisAngle(Vector3D.UnitY, Math.PI / 2.0)
        * UnitQuaternion.FromAxisAngle(Vector3D.UnitX, 0.7);

    /// <summary>m: two degrees over the plane of the pole, turning faster than the real one.</summary>
    private static Vector3D SunAt(double seconds) => 1.5e11 * new Vector3D(
        Math.Cos(double.DegreesToRadians(2.0)) * Math.Cos(1.0 + (0.01 * seconds)),
        Math.Cos(double.DegreesToRadians(2.0)) * Math.Sin(1.0 + (0.01 * seconds)), -Math.Sin(double.DegreesToRadians(2.0)));
}
