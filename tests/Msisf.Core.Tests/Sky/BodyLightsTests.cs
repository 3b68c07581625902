using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Sky;
using Msisf.Core.Surface;
using Msisf.Core.Time;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Sky;

/// <summary>The light of bodies of the sky in a detector while the camera flies.</summary>
public sealed class BodyLightsTests
{
    private const int Side = 48;
    private const double PixelRadians = 0.0005;
    private const double Span = 2.0; // s
    private const double Distance = 1.6e9; // m: discs of 8 px
    private const double Speed = 4e6; // m/s: 10 px in the exposure

    private static readonly CameraModel Model = CameraModel.FromFieldOfView(Side * PixelRadians, Side, Side);

    private static readonly DetectorSettings Settings = new()
    {
        ApertureArea = 1.0,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(1.0)),
        ExposureTime = Span,
        Gain = 1.0,
        ConverterBits = 16,
    };

    /// <summary>
    /// The Earth moves through the image by the flight of the camera and by its own: an even streak of the length L has a variance of
    /// L^2/12.
    /// </summary>
    [Theory]
    [InlineData(Speed, 0.0, 10.0)]
    [InlineData(0.0, Speed, 10.0)]
    [InlineData(Speed, Speed, 0.0)]
    [InlineData(Speed, -0.5 * Speed, 15.0)]
    public void Collect_FlyingCamera_MovesTheEarth(double ofCamera, double ofEarth, double length)
    {
        const double SameVariance = 0.06; // px^2: 40 instants; the phase moves the middle of the light by 1e-3 of the way
        FlyingEarth ephemeris = new(ofEarth * Vector3D.UnitY);
        double still = Variance(new FlyingEarth(default), 0.0);

        double moving = Variance(ephemeris, ofCamera);

        Assert.Equal(length * length / 12.0, moving - still, SameVariance);
    }

    /// <summary>Ground that hides half of the Earth for half of the exposure takes a quarter of its light.</summary>
    [Fact]
    public void Collect_RidgePassesInFront_TakesItsPart()
    {
        const double SameLight = 0.01; // an instant more or less of some hundred
        double whole = Collect(new FlyingEarth(default), 1e4, new Ridge(0.0)).Sum();

        double halved = Collect(new FlyingEarth(default), 1e4, new Ridge(1e4)).Sum();

        Assert.Equal(0.75, halved / whole, SameLight);
    }

    /// <summary>The Earth's dark side hides stars: the Sun is behind it.</summary>
    [Theory]
    [InlineData(0.97, true)]
    [InlineData(1.03, false)]
    public void Collect_StarBehindTheEarth_IsHidden(double radii, bool isHidden)
    {
        FrameCamera camera = Model.At(new CameraState(2e6 * Vector3D.UnitX, UnitQuaternion.Identity));
        SkyAxes axes = SkyAxes.At(
            Moments.OfMjd(55289.0), camera.State, null, new FlyingEarth(default, -1.0), 1_737_400.0, [SkyBody.Earth]);
        double aside = radii * Math.Asin(6_378_136.6 / Distance);
        Star star = new("S", new Vector3D(-Math.Cos(aside), Math.Sin(aside), 0.0), default, 0.0, 0.0, 0.0, 0.0);
        StarLights lights = new(
            new FrameSky(new StarCatalogue([star]), camera, [axes], 0.1), new Ridge(0.0), new StarBrightness(static _ => 1e6));
        DetectorImage image = new(Side, Side);

        lights.Collect(
            new PointExposure(new PixelRows(0, Side), _ => camera, 0.0, 0.0), new CameraDetector(Settings, camera, 1), image,
            CancellationToken.None);
        StarView view = Assert.Single(lights.Find(camera, hasDetector: true, threads: 1, CancellationToken.None).Views);

        Assert.Equal(isHidden, image.Electrons.Sum() == 0.0);
        Assert.Equal(isHidden ? SkyBody.Earth : null, view.Behind);
        Assert.Equal(!isHidden, view.IsVisible);
    }

    private static double Variance(IEphemeris ephemeris, double speed)
    {
        double[] electrons = Collect(ephemeris, speed, new Ridge(0.0));
        double sum = electrons.Sum();
        double mean = electrons.Select((light, index) => light * (index % Side)).Sum() / sum;
        return electrons.Select((light, index) => light * ((index % Side) - mean) * ((index % Side) - mean)).Sum() / sum;
    }

    private static double[] Collect(IEphemeris ephemeris, double speed, ITerrainTracer tracer)
    {
        FrameCamera camera = CameraAt(0.0);
        SkyAxes axes = SkyAxes.At(Moments.OfMjd(55289.0), camera.State, null, ephemeris, 1_737_400.0, [SkyBody.Earth]);
        DetectorImage image = new(Side, Side);
        CameraDetector detector = new(Settings with { IsFlatFielded = true }, camera, 1);
        BodyLights lights = new([axes], tracer, 1e9);
        lights.Collect(
            new PointExposure(new PixelRows(0, Side), CameraAt, 0.0, Span), detector, image, CancellationToken.None);
        return image.Electrons;

        FrameCamera CameraAt(double seconds) => Model.At(
            new CameraState(new Vector3D(2e6, speed * seconds, 0.0), UnitQuaternion.Identity) with { Seconds = seconds });
    }

    /// <summary>Hides what is above a camera whose second coordinate is between 0 and a limit.</summary>
    private sealed class Ridge(double limit) : ITerrainTracer
    {
        public double MaxRadius => 1_748_200.0;

        public bool TryTrace(Ray ray, out SurfaceHit hit)
        {
            hit = default;
            return ray.Direction.Z > 0.0 && ray.Origin.Y > 0.0 && ray.Origin.Y < limit;
        }

        public bool IsHidden(Vector3D pointBodyFixed, FacetId facet, Vector3D lightBodyFixed) => throw new NotSupportedException();
    }

    /// <summary>A Moon that stands still along J2000's axes, the Earth before the camera, the Sun on either side.</summary>
    private sealed class FlyingEarth(Vector3D velocity, double sunSide = 1.0) : IEphemeris
    {
        public string EngineName => "flying Earth";

        public TimeScale TimeScale => throw new NotSupportedException();

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) => throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) => RotationMatrix.Identity;

        public Vector3D BodyRateJ2000(TdbTime time) => default;

        public StateVector StateOf(int naifNumber, TdbTime time) => naifNumber switch
        {
            399 => new StateVector((2e6 - Distance) * Vector3D.UnitX, velocity),
            10 => new StateVector(sunSide * 1.5e11 * Vector3D.UnitX, default),
            _ => default,
        };
    }
}
