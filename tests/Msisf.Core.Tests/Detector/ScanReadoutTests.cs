using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Detector;

/// <summary>Scanned images with a detector, against sums of frames that are exposed one by one.</summary>
public sealed class ScanReadoutTests
{
    private const int Width = 48;
    private const double Exposure = 0.2;

    /// <summary>1: sums of the same electrons in another order.</summary>
    private const double Rounding = 1e-13;

    private static readonly Instant Time = Moments.OfMjd(55289.0);
    private static readonly SceneLight Sun = new(new Vector3D(1.1e11, 0.9e11, 2e10), IsSun: true);
    private static readonly CameraMotion Motion = new(new Vector3D(100.0, 3000.0, 2500.0), new Vector3D(0.03, -0.02, 0.05));
    private static readonly NativeRenderer Renderer = new(FunctionGrid.Rugged(2));
    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.5) };

    [Theory]
    [InlineData(ScanKind.LineScan, 1)]
    [InlineData(ScanKind.PushFrame, 3)]
    [InlineData(ScanKind.RollingShutter, 7)]
    public void Expose_EachExposure_HasTheElectronsOfItsFrame(ScanKind kind, int height)
    {
        CameraModel model = Model(height);
        Scan scan = new(kind, kind == ScanKind.RollingShutter ? height : 5, 0.7) { FlipsFramelets = kind == ScanKind.PushFrame };
        DetectorSettings settings = Settings with { PointSpread = PointSpreadKernel.Of(new GaussianSpread(1.2), 3.0) };
        DetectorImage image = Expose(scan, model, settings, 2, out ICamera camera);

        for (int y = 0; y < camera.Height; y++)
        {
            int exposure = kind == ScanKind.PushFrame ? y / height : y;
            int row = kind == ScanKind.LineScan ? 0 : kind == ScanKind.PushFrame ? height - 1 - (y % height) : y;
            double[] expected = ElectronsOf(model, Motion.Moved(Start, 0.7 * exposure), settings);
            AssertClose(expected.AsSpan(row * Width, Width), image.Electrons.AsSpan(y * Width, Width), Rounding);
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Expose_Tdi_AddsTheRowsThatSeeOneAfterTheOther(bool movesDown)
    {
        CameraModel model = Model(4);
        Scan scan = new(ScanKind.LineScan, 3, 0.15) { Stages = 4, ChargeMovesDown = movesDown };
        DetectorImage image = Expose(scan, model, Settings, 2, out _);

        for (int line = 0; line < 3; line++)
        {
            double[] sum = new double[Width];
            for (int stage = 0; stage < 4; stage++)
            {
                double seconds = 0.15 * (line + stage - 1.5);
                double[] all = ElectronsOf(model, Motion.Moved(Start, seconds), Settings);
                int row = movesDown ? stage : 3 - stage;
                for (int x = 0; x < Width; x++)
                {
                    sum[x] += all[(row * Width) + x];
                }
            }

            // Each stage has the throughput of the middle of the rows; that of these wide pixels differs by less than 1e-3 at their ends.
            AssertClose(sum, image.Electrons.AsSpan(line * Width, Width), 1e-3);
        }
    }

    [Fact]
    public void Expose_MovingShutter_IsTheMeanOfItsInstants()
    {
        Scan scan = new(ScanKind.LineScan, 4, 0.7);
        DetectorSettings settings = Settings with { Shutter = new Shutter { MaxStep = 0.05 } };
        DetectorImage image = Expose(scan, Model(1), settings, 2, out _);

        const int Instants = 64;
        for (int line = 0; line < 4; line++)
        {
            double[] mean = new double[Width];
            for (int i = 0; i < Instants; i++)
            {
                double seconds = (0.7 * line) + ((((i + 0.5) / Instants) - 0.5) * Exposure);
                double[] all = ElectronsOf(Model(1), Motion.Moved(Start, seconds), Settings);
                for (int x = 0; x < Width; x++)
                {
                    mean[x] += all[x] / Instants;
                }
            }

            AssertClose(mean, image.Electrons.AsSpan(line * Width, Width), 0.01);
        }
    }

    /// <summary>Rows that are exposed by themselves are those of the whole image, noise too.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Expose_SomeRows_AreThoseOfTheWhole(bool up)
    {
        CameraModel model = Model(3);
        Scan scan = new(ScanKind.PushFrame, 4, 0.7) { GrowsUpwards = up, FlipsFramelets = up };
        DetectorSettings settings = Settings with { Gain = 1e9, ReadNoise = 3e10, Seed = 5 };
        DetectorImage whole = Expose(scan, model, settings, 2, out _);
        DetectorImage part = Expose(scan, model, settings, 2, out _, rows: new PixelRows(6, 9));

        Assert.Equal(whole.Numbers[(6 * Width)..(9 * Width)], part.Numbers);
        Assert.Equal(whole.Electrons[(6 * Width)..(9 * Width)], part.Electrons);
    }

    /// <summary>Noise of lines in one state differs; it is the same with more threads, and with the same seed of the frame.</summary>
    [Fact]
    public void Expose_Noise_IsEachLinesOwn()
    {
        Scan scan = new(ScanKind.LineScan, 3, 0.7);
        DetectorSettings settings = Settings with { Gain = 1e9, ReadNoise = 3e10, Seed = 5 };
        ushort[] numbers = Expose(scan, Model(1), settings, 1, out _, CameraMotion.FromNumbers(new double[6])).Numbers;

        Assert.NotEqual(numbers[..Width], numbers[Width..(2 * Width)]);
        Assert.Equal(numbers, Expose(scan, Model(1), settings, 3, out _, default(CameraMotion)).Numbers);
        ushort[] seeded = Expose(scan, Model(1), settings, 2, out _, default(CameraMotion), new NoiseSeed(9, 4)).Numbers;
        Assert.NotEqual(numbers, seeded);
        Assert.NotEqual(seeded[..Width], seeded[Width..(2 * Width)]);
    }

    private static CameraState Start
    {
        get
        {
            Vector3D position = (MoonConstants.ReferenceRadius + 120_000.0) * new Vector3D(0.8, 0.6, 0.0);
            return new CameraState(position, NadirPointing.MoonFromCamera(position));
        }
    }

    private static DetectorSettings Settings { get; } = new()
    {
        ApertureArea = 1e-4,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(0.5)),
        ExposureTime = Exposure,
        Gain = 1e4,
        ConverterBits = 16,
    };

    private static CameraModel Model(int height) => new(Width, height, (60.0, 62.0), (22.0, 0.7 * height), skew: 0.4);

    private static DetectorImage Expose(
        Scan scan, CameraModel model, DetectorSettings settings, int threads, out ICamera camera, CameraMotion? motion = null,
        NoiseSeed? noise = null, PixelRows? rows = null)
    {
        ScanPath path = new ScanPath(seconds => (motion ?? Motion).Moved(Start, seconds)).Of(scan, null, 0.0);
        camera = scan.CameraOf(model, path.States);
        ScannedShot shot = new(scan, model, path, camera, Sun, Time, noise, settings.Shutter is null ? 0.0 : 0.5 * Exposure);
        CameraDetector detector = new(settings, ScanReadout.CameraOf(shot), threads);
        (NativeFrame drawn, DetectorImage image) = new ScanReadout(detector, Renderer, Options).Expose(
            shot, rows ?? new PixelRows(0, camera.Height), threads, default);
        drawn.Dispose();
        return image;
    }

    /// <summary>A frame of the whole camera, exposed at an instant.</summary>
    private static double[] ElectronsOf(CameraModel model, CameraState state, DetectorSettings settings)
    {
        FrameCamera camera = model.At(state with { Seconds = 0.0 });
        CameraDetector detector = new(settings with { Shutter = null }, camera, 1);
        using NativeFrame drawn = Renderer.Render(detector.WindowOf(camera), Sun, Options, threads: 1);
        DetectorImage image = detector.Begin(drawn);
        detector.Collect(drawn, 1.0, image, 1, default);
        return image.Electrons;
    }

    private static void AssertClose(ReadOnlySpan<double> expected, ReadOnlySpan<double> actual, double relative)
    {
        double greatest = 0.0;
        for (int x = 0; x < expected.Length; x++)
        {
            greatest = Math.Max(greatest, expected[x]);
        }

        Assert.True(greatest > 0.0);
        for (int x = 0; x < expected.Length; x++)
        {
            Assert.Equal(expected[x] / greatest, actual[x] / greatest, relative);
        }
    }
}
