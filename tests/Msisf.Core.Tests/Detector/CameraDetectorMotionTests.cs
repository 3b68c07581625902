using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Detector;

/// <summary>A camera 100 km over a smooth Moon, with pixels of 1 km at the nadir, moves while its shutter is open.</summary>
public sealed class CameraDetectorMotionTests
{
    private const int Side = 64;
    private const double Focal = 100.0; // px
    private const double Height = 1e5; // m

    private static readonly SceneLight Sun = new(new Vector3D(1.5e11, 0.0, 0.0), IsSun: true);
    private static readonly CameraModel Model = CameraModel.FromFieldOfView(2.0 * Math.Atan(0.5 * Side / Focal), Side, Side);

    /// <summary>
    /// The spot's spread along the motion grows by that of an even line of the motion's length, L^2 / 12 less L^2 / (12 n^2) for n points
    /// in place of the line; across it, it stays.
    /// </summary>
    [Fact]
    public void Collect_SpotUnderAMovingCamera_IsSmearedByTheLengthOfTheMotion()
    {
        const double Length = 5.0; // px: 5 km/s for 1 s
        Spot still = SpotOf(Expose(Settings(1.0), Map(IsSpot), default).Electrons);
        (double[] electrons, int count) = Expose(Settings(1.0), Map(IsSpot), new CameraMotion(new Vector3D(0.0, 5000.0, 0.0), default));
        Spot smeared = SpotOf(electrons);

        Assert.Equal(21, count);
        Assert.Equal(1.0, smeared.Sum / still.Sum, 2e-3);
        Assert.Equal(Length * Length / 12.0 * (1.0 - (1.0 / (21 * 21))), smeared.VarianceX - still.VarianceX, 0.02);
        Assert.Equal(0.0, smeared.VarianceY - still.VarianceY, 0.005);
        Assert.Equal(still.X, smeared.X, 0.01);
    }

    /// <summary>A turn about the right axis moves the image up or down by the focal length times the angle in its middle.</summary>
    [Fact]
    public void Collect_SpotUnderATurningCamera_IsSmearedByTheAngle()
    {
        const double Length = 4.0; // px: 0.04 rad
        Spot still = SpotOf(Expose(Settings(0.5), Map(IsSpot), default).Electrons);
        (double[] electrons, int count) = Expose(Settings(0.5), Map(IsSpot), new CameraMotion(default, new Vector3D(0.0, 0.08, 0.0)));
        Spot smeared = SpotOf(electrons);

        Assert.Equal(Length * Length / 12.0 * (1.0 - (1.0 / (count * count))), smeared.VarianceY - still.VarianceY, 0.02);
        Assert.Equal(0.0, smeared.VarianceX - still.VarianceX, 0.005);
        Assert.Equal(1.0, smeared.Sum / still.Sum, 2e-3);
    }

    [Fact]
    public void Collect_CameraAtRest_IsTheImageWithoutAShutterToTheBit()
    {
        DetectorSettings instant = Settings(1.0) with { Shutter = null };
        double[] expected = Expose(instant, Map(IsSpot), default).Electrons;
        Assert.Equal(expected, Expose(Settings(1.0), Map(IsSpot), default).Electrons);
        Assert.Equal(
            expected, Expose(Settings(1.0) with { Shutter = new Shutter { MaxStep = 0.1 } }, Map(IsSpot), default).Electrons);
    }

    [Fact]
    public void Collect_MoreThreads_IsTheSameToTheBit()
    {
        CameraMotion motion = new(new Vector3D(300.0, 4000.0, 1000.0), new Vector3D(0.1, 0.02, -0.03));
        DetectorSettings settings = Settings(0.3);
        Assert.Equal(Expose(settings, Map(IsSpot), motion, 1).Electrons, Expose(settings, Map(IsSpot), motion, 3).Electrons);
    }

    [Theory]
    [InlineData(1e6, 0.0)]
    [InlineData(1e30, 0.0)]
    [InlineData(0.0, 1e3)]
    [InlineData(0.0, 1e30)]
    public void SubExposuresOf_TooFast_SaysWhatToDo(double speed, double rate)
    {
        CameraMotion motion = new(new Vector3D(0.0, speed, 0.0), new Vector3D(rate, 0.0, 0.0));
        BadInputException error = Assert.Throws<BadInputException>(() => Expose(Settings(1.0), Map(IsSpot), motion));
        Assert.Contains("999 is the most. Give the camera file a larger 'motion-step'", error.Message, StringComparison.Ordinal);
    }

    /// <summary>Turns by an angle a: f a r about the axis; beside it f a (1 + t^2, t^2) at the corner of tangents t.</summary>
    [Theory]
    [InlineData(0.02, 0.0, 0.02 * 32.0 * 1.41421356)]
    [InlineData(0.0, 0.02, 0.02 * 100.0 * 1.1071459)]
    public void Greatest_Turning_IsThatOfTheCorner(double roll, double pitch, double expected)
    {
        using NativeFrame frame = Draw(Camera, null, 1);
        CameraMotion motion = new(default, new Vector3D(roll, pitch, 0.0));
        double greatest = ImageMotion.Greatest(frame, motion, 1.0, 999, 2, CancellationToken.None);
        Assert.InRange(greatest, expected * 0.9999, expected * 1.01); // chords of the path; it goes on as where it is fastest
    }

    /// <summary>Facets of 0.25 degrees lie up to 4 m below the sphere.</summary>
    private static NativeRenderer Renderer { get; } = new(FunctionGrid.OfHeights(4, (_, _) => 0.0));

    private static FrameCamera Camera
    {
        get
        {
            Vector3D position = new(MoonConstants.ReferenceRadius + Height, 0.0, 0.0);
            return Model.At(new CameraState(position, NadirPointing.MoonFromCamera(position)));
        }
    }

    private static bool IsSpot(int x, int y) => x is >= 62 and < 66 && y is >= 62 and < 66;

    /// <summary>4 x 4 degrees about (0, 0) in pixels of 0.95 km, bright on almost black.</summary>
    private static AlbedoMap Map(Func<int, int, bool> isBright)
    {
        double side = double.DegreesToRadians(4.0);
        return SyntheticMaps.Of(128, 128, new MapExtent(-0.5 * side, 0.5 * side, side, side), (x, y) => isBright(x, y) ? 10000 : 1);
    }

    private static DetectorSettings Settings(double exposureTime) => new()
    {
        ApertureArea = 1e-4,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(0.5)),
        ExposureTime = exposureTime,
        Shutter = new Shutter(),
        IsFlatFielded = true,
        Gain = 1.0,
        ConverterBits = 16,
    };

    private static NativeFrame Draw(ICamera camera, AlbedoMap? map, int threads) => Renderer.Render(
        camera,
        Sun,
        new NativeRenderOptions
        {
            Reflectance = new LambertReflectance(0.5),
            Albedo = map,
            Normals = NormalModel.Smooth,
            SubsamplesPerAxis = 3,
            KeepGroundTruth = true,
        },
        threads);

    private static (double[] Electrons, int Count) Expose(
        DetectorSettings settings, AlbedoMap map, CameraMotion motion, int threads = 2)
    {
        CameraDetector detector = new(settings, Camera, threads);
        using NativeFrame middle = Draw(Camera, map, threads);
        SubExposures exposures = detector.SubExposuresOf(middle, motion, threads, CancellationToken.None);
        DetectorImage image = detector.Begin(middle);
        for (int index = 0; index < exposures.Count; index++)
        {
            using NativeFrame drawn = Draw(Camera.Moved(motion, exposures.TimeOf(index)), map, threads);
            detector.Collect(drawn, exposures.Weight, image, threads, CancellationToken.None);
        }

        return (image.Electrons, exposures.Count);
    }

    /// <summary>Sum and moments of what is brighter than 0.05 % of the brightest.</summary>
    private static Spot SpotOf(ReadOnlySpan<double> electrons)
    {
        double floor = 0.0;
        foreach (double value in electrons)
        {
            floor = Math.Max(floor, 0.0005 * value);
        }

        (double sum, double x, double y, double xx, double yy) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (int i = 0; i < electrons.Length; i++)
        {
            double value = electrons[i] > floor ? electrons[i] : 0.0;
            (double column, double row) = ((i % Side) + 1, (i / Side) + 1);
            (sum, x, y) = (sum + value, x + (value * column), y + (value * row));
            (xx, yy) = (xx + (value * column * column), yy + (value * row * row));
        }

        return new Spot(sum, x / sum, (xx / sum) - (x / sum * x / sum), (yy / sum) - (y / sum * y / sum));
    }

    private readonly record struct Spot(double Sum, double X, double VarianceX, double VarianceY);
}
