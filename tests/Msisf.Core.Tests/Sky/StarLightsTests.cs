using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Sky;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Time;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Sky;

/// <summary>The light of stars in a detector, and what hides them.</summary>
public sealed class StarLightsTests
{
    private const int Side = 48;
    private const double Field = 0.02;
    private const double Span = 2.0;
    private const double Electrons = 1e6;
    private const double Highest = 1_748_200.0; // m

    /// <summary>The Moon of these tests stands still along J2000's axes, in the middle of the solar system.</summary>
    private static readonly StillMoon Ephemeris = new();

    private static readonly CameraModel Model = CameraModel.FromFieldOfView(Field, Side, Side);

    private static readonly CameraState Outside = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity);

    private static readonly DetectorSettings Settings = new()
    {
        ApertureArea = 1.0,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(1.0)),
        ExposureTime = Span,
        Gain = 1.0,
        ConverterBits = 16,
    };

    /// <summary>A camera that turns about all its axes: the light lies where 10 000 points at even times put it.</summary>
    [Theory]
    [InlineData(0.8)]
    [InlineData(0.4)]
    [InlineData(null)]
    public void Collect_TurningCamera_IsTheSumOfManyPoints(double? sigma)
    {
        const int Dots = 10_000;
        DetectorSettings settings = Settings with
        {
            PointSpread = sigma is { } width ? PointSpreadKernel.Of(new GaussianSpread(width), 7.0) : null,
        };
        CameraMotion motion = new(new Vector3D(10.0, 1000.0, 300.0), new Vector3D(0.02, 1.3e-3, 2.1e-3));
        Star star = StarAt(Model.At(Outside), 25.3, 20.6);
        PointExposure exposure = new(
            new PixelRows(0, Side), seconds => (FrameCamera)Model.At(Outside).Moved(motion, seconds), 0.0, Span)
        {
            AngularSpeed = motion.AngularVelocityCamera.Length,
        };

        double[] actual = Collect(settings, [star], exposure, new NoGround(), out StarsOfFrame found);

        PointImage point = new(settings.PointSpread);
        double[] expected = new double[Side * Side];
        for (int i = 0; i < Dots; i++)
        {
            double seconds = Span * (((i + 0.5) / Dots) - 0.5);
            Assert.True(((FrameCamera)Model.At(Outside).Moved(motion, seconds)).TryProject(star.Direction, out RenderingPoint seen));
            point.Add(expected, Side, (0, Side), seen.X, seen.Y, Electrons / Dots);
        }

        // Some 10 px of way: a dot is a thousandth of a pixel, of which a pixel's border cuts one.
        double tolerance = sigma is null ? 2.0 * Electrons / Dots : 1e-5 * Electrons;
        Assert.All(expected.Zip(actual), pair => Assert.Equal(pair.First, pair.Second, tolerance));
        Assert.True(actual.Count(electrons => electrons > 0.01 * Electrons) > 8);
        Assert.Equal(1.0, found.Views[0].Electrons!.Value / actual.Sum(), 1e-5); // but for the flat field
        Assert.True(MovedPlace(motion, star, -0.5 * Span) is var start && MovedPlace(motion, star, 0.5 * Span) is var end
            && found.Views[0].Streak is var (from, to)
            && Near(from, start) && Near(to, end));
    }

    /// <summary>A star at the image's border: what it gets and what its neighbour gets are all.</summary>
    [Fact]
    public void Collect_StarBesideTheImage_GivesItsSpreadLight()
    {
        DetectorSettings settings = Settings with { PointSpread = PointSpreadKernel.Of(new GaussianSpread(1.0), 7.0) };
        Star beside = StarAt(Model.At(Outside), Side + 1.5, 20.0);

        double[] actual = Collect(settings, [beside], Instant(), new NoGround(), out StarsOfFrame found);

        Assert.Empty(found.Views);
        Assert.Equal(Electrons * 0.15865525, actual.Sum(), 20.0); // beyond one sigma: Abramowitz and Stegun, table 26.1
    }

    /// <summary>Ground that hides the star from a time on takes the rest of its light.</summary>
    [Fact]
    public void Collect_StarThatSets_HasTheLightOfItsTime()
    {
        const double Sets = 0.123_456_789; // s
        Star star = StarAt(Model.At(Outside), 20.0, 20.0);
        PointExposure exposure = new(
            new PixelRows(0, Side), seconds => Model.At(Outside with { PositionBodyFixed = new Vector3D(2e6, seconds, 0.0) }), 0.0, Span)
        {
            AngularSpeed = 0.01,
        };

        double[] actual = Collect(Settings, [star], exposure, new GroundFrom(Sets), out StarsOfFrame found);

        Assert.Equal(Electrons * (0.5 + (Sets / Span)), actual.Sum(), 1.0);
        Assert.Null(found.Views[0].HiddenBy);
    }

    /// <summary>A camera that flies and does not turn: a ridge hides the star for a while in the middle of the exposure.</summary>
    [Fact]
    public void Collect_RidgePassesInFront_TakesTheLightOfItsTime()
    {
        const double Speed = 1e4; // m/s
        const double Begin = -0.3; // s
        const double End = -0.1;
        Star star = StarAt(Model.At(Outside), 20.0, 20.0);
        PointExposure exposure = new(
            new PixelRows(0, Side),
            seconds => Model.At(Outside with { PositionBodyFixed = new Vector3D(2e6, Speed * seconds, 0.0) }), 0.0, Span);

        double[] actual = Collect(Settings, [star], exposure, new GroundFrom(Speed * Begin, Speed * End), out StarsOfFrame _);

        Assert.Equal(Electrons * (1.0 - ((End - Begin) / Span)), actual.Sum(), 1.0);
    }

    /// <summary>2 000 stars within a tenth of a degree of the limb, against each facet of the Moon.</summary>
    [Fact]
    public void Find_StarsAtTheLimb_AreHiddenByTheFacetsThere()
    {
        const int Count = 2_000;
        FunctionGrid grid = FunctionGrid.Rugged(4);
        BruteForceMoon judge = new(grid);
        FrameCamera camera = CameraModel.FromFieldOfView(1.6, 1000, 1000).At(
            new CameraState(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity));
        Random random = new(49);
        Star[] stars = [.. Enumerable.Range(0, Count).Select(index =>
        {
            double aside = Math.Asin(1_737_400.0 / 4e6) + (0.0035 * ((2.0 * random.NextDouble()) - 1.0));
            double turn = 2.0 * Math.PI * random.NextDouble();
            (double sin, double cos) = Math.SinCos(aside);
            return At($"{index}", new Vector3D(-cos, sin * Math.Cos(turn), sin * Math.Sin(turn)));
        })];
        StarLights lights = new(Sky(stars, camera), new TerrainTracer(grid), Brightness);

        StarsOfFrame found = lights.Find(camera, hasDetector: false, threads: 2, CancellationToken.None);

        Assert.Equal(Count, found.Views.Count);
        int hidden = 0;
        foreach (StarView view in found.Views)
        {
            bool expected = judge.FirstHit(camera.PositionBodyFixed, view.Star.Direction) is not null;
            Assert.Equal(expected, view.HiddenBy is not null);
            hidden += expected ? 1 : 0;
        }

        Assert.InRange(hidden, Count / 5, Count * 4 / 5);
    }

    /// <summary>Ten stars that set behind a rugged limb: the light tells when, against each facet of the Moon.</summary>
    [Fact]
    public void Collect_StarsThatSetAlongAnOrbit_TellWhenToAMillisecond()
    {
        const int Count = 10;
        const double Orbit = 4e6; // m
        const double Rate = 2.7678e-4; // rad/s: sqrt(4.9028e12 / Orbit^3)
        const double Step = 1.0; // s
        const double SameTime = 1e-3; // s: what navigation by occultations asks for
        FunctionGrid grid = FunctionGrid.Rugged(4);
        BruteForceMoon judge = new(grid);
        TerrainTracer tracer = new(grid);
        CameraModel model = CameraModel.FromFieldOfView(1.6, 1000, 1000);
        Random random = new(1_049);
        int found = 0;
        for (int tries = 0; found < Count && tries < 20 * Count; tries++)
        {
            double aside = Math.Asin(1_737_400.0 / Orbit) + (0.002 * random.NextDouble());
            (double sin, double cos) = Math.SinCos(aside);
            (double up, double ahead) = Math.SinCos(random.NextDouble() - 0.5);
            Vector3D direction = new(-cos, -sin * ahead, sin * up); // the Moon moves there as the camera flies on
            bool IsHidden(double time) => judge.FirstHit(Place(time), direction) is not null;
            double before = Enumerable.Range(0, 12).Select(index => index * Step).FirstOrDefault(
                time => !IsHidden(time) && IsHidden(time + Step), double.NaN);
            if (double.IsNaN(before))
            {
                continue;
            }

            (double seen, double hidden) = (before, before + Step);
            while (hidden - seen > 1e-7)
            {
                double middle = 0.5 * (seen + hidden);
                (seen, hidden) = IsHidden(middle) ? (seen, middle) : (middle, hidden);
            }

            FrameCamera camera = model.At(StateAt(before + (0.5 * Step)));
            StarLights lights = new(
                Sky([At($"{tries}", direction)], camera), tracer, new StarBrightness(_ => Electrons / Step));
            PointExposure exposure = new(
                new PixelRows(0, 1000), seconds => model.At(StateAt(before + (0.5 * Step) + seconds)), 0.0, Step);
            DetectorImage image = new(1000, 1000);
            CameraDetector detector = new(Settings with { ExposureTime = Step, IsFlatFielded = true }, camera, 1);
            lights.Collect(exposure, detector, image, CancellationToken.None);

            double share = image.Electrons.Sum() * SolidAngleOverCentre(camera, direction) / Electrons;
            Assert.Equal(seen, before + (share * Step), SameTime);
            found++;
        }

        Assert.Equal(Count, found);

        static Vector3D Place(double time) =>
            Orbit * new Vector3D(Math.Cos(Rate * time), Math.Sin(Rate * time), 0.0);

        static CameraState StateAt(double time) => new(Place(time), UnitQuaternion.Identity);
    }

    private static PointExposure Instant() => new(new PixelRows(0, Side), _ => Model.At(Outside), 0.0, 0.0);

    private static StarBrightness Brightness => new(_ => 1.0);

    /// <summary>The electrons of stars of which each frees <see cref="Electrons"/>, where the axis is near.</summary>
    private static double[] Collect(
        DetectorSettings settings, Star[] stars, PointExposure exposure, ITerrainTracer tracer, out StarsOfFrame found)
    {
        FrameCamera camera = Model.At(Outside);
        DetectorImage image = new(Side, Side);
        StarLights lights = new(Sky(stars, camera), tracer, new StarBrightness(_ => Electrons / Span));
        lights.Collect(exposure, new CameraDetector(settings with { IsFlatFielded = true }, camera, 1), image, CancellationToken.None);
        found = lights.Find(camera, hasDetector: true, threads: 1, CancellationToken.None);
        double flat = SolidAngleOverCentre(camera, stars[0].Direction);
        return [.. image.Electrons.Select(electrons => electrons * flat)];
    }

    /// <summary>A flat field makes stars off the axis brighter, by the size of pixels there.</summary>
    private static double SolidAngleOverCentre(FrameCamera camera, Vector3D direction)
    {
        double cosine = Vector3D.Dot(camera.ForwardBodyFixed, direction);
        return cosine * cosine * cosine;
    }

    private static FrameSky Sky(Star[] stars, FrameCamera camera) => new(
        new StarCatalogue(stars), camera, [SkyAxes.At(Moments.OfMjd(55289.0), camera.State, null, Ephemeris, 1_737_400.0)], 0.1);

    private static Star StarAt(FrameCamera camera, double x, double y) => At("S", camera.RayThrough(x, y).Direction.Normalized());

    private static Star At(string name, Vector3D direction) => new(name, direction, default, 0.0, 0.0, 0.0, 0.0);

    private static RenderingPoint MovedPlace(CameraMotion motion, Star star, double seconds)
    {
        Assert.True(((FrameCamera)Model.At(Outside).Moved(motion, seconds)).TryProject(star.Direction, out RenderingPoint seen));
        return seen;
    }

    private static bool Near(RenderingPoint a, RenderingPoint b) => double.Hypot(a.X - b.X, a.Y - b.Y) < 1e-9;

    private sealed class NoGround : ITerrainTracer
    {
        public double MaxRadius => Highest;

        public bool TryTrace(Ray ray, out SurfaceHit hit)
        {
            hit = default;
            return false;
        }

        public bool IsHidden(Vector3D pointBodyFixed, FacetId facet, Vector3D lightBodyFixed) => throw new NotSupportedException();
    }

    /// <summary>Ground in front of cameras whose second coordinate, which counts the seconds, lies between limits.</summary>
    private sealed class GroundFrom(double limit, double end = double.PositiveInfinity) : ITerrainTracer
    {
        public double MaxRadius => Highest;

        public bool TryTrace(Ray ray, out SurfaceHit hit)
        {
            hit = default;
            return ray.Origin.Y > limit && ray.Origin.Y < end;
        }

        public bool IsHidden(Vector3D pointBodyFixed, FacetId facet, Vector3D lightBodyFixed) => throw new NotSupportedException();
    }

    private sealed class StillMoon : IEphemeris
    {
        public string EngineName => "still Moon";

        public TimeScale TimeScale => throw new NotSupportedException();

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) => throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) => RotationMatrix.Identity;

        public Vector3D BodyRateJ2000(TdbTime time) => default;

        public StateVector StateOf(int naifNumber, TdbTime time) => default;
    }
}
