using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

/// <summary>Discs against points of their rims, each projected by itself.</summary>
public class CraterDiscTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    /// <summary>px.</summary>
    private const double PixelError = 1e-9;

    /// <summary>m: rounding of a position on the Moon.</summary>
    private const double PositionError = 1e-9;

    [Fact]
    public void TryProject_AnyPinhole_HasAllPointsOfTheRimOnTheEllipse()
    {
        int seen = 0;
        int hyperbolas = 0;
        for (int number = 0; number < TestLength.Of(120, 5000); number++)
        {
            FrameCamera camera = OddCamera(number);
            foreach (Crater crater in CratersBelow(number, camera))
            {
                CraterDisc disc = CraterDisc.Of(crater, 1_737_400.0 - (100.0 * (number % 7)));
                RenderingPoint[] rim = new RenderingPoint[72];
                int inFront = rim.Select((_, i) => camera.TryProjectPoint(disc.RimAt(Math.PI * i / 36.0), out rim[i])).Count(is1 => is1);
                if (!disc.TryProject(camera, out ImageEllipse ellipse))
                {
                    hyperbolas += inFront > 0 ? 1 : 0;
                    Assert.NotEqual(rim.Length * 100, inFront * 101);
                    continue;
                }

                seen++;
                Assert.Equal(rim.Length, inFront);
                double scale = Math.Max(camera.Model.FocalX, camera.Model.FocalY);
                double least = Enumerable.Range(0, 72).Min(i => Vector3D.Dot(
                    disc.RimAt(Math.PI * i / 36.0) - camera.PositionBodyFixed, camera.ForwardBodyFixed));
                double size = rim.Max(point => Math.Max(Math.Abs(point.X), Math.Abs(point.Y)));
                double error = PixelError + (4.0 * scale * PositionError / least) + (1e-14 * size * size / ellipse.SemiMinor);
                Assert.All(rim, point => Assert.InRange(ellipse.DistanceTo(point.X, point.Y), 0.0, error));
                RenderingPoint middle = default;
                Assert.True(camera.TryProjectPoint(disc.Centre, out middle));
                (double x, double y) = ellipse.ToUnitCircle(middle.X, middle.Y);
                Assert.True((x * x) + (y * y) < 1.0, "the centre of a disc is seen inside its rim");
            }
        }

        Assert.True(seen > 300 && hyperbolas > 5, $"{seen} ellipses, {hyperbolas} hyperbolas");
    }

    /// <summary>A circle straight below: diameter = focal length x diameter / distance, which nothing here computes.</summary>
    [Fact]
    public void TryProject_CircleStraightBelow_IsACircleOfKnownSize()
    {
        PinholeCamera camera = new(
            new Vector3D(1_837_400.0, 0.0, 0.0), UnitQuaternion.FromComponents(0.0, 0.0, 0.0, 1.0), 2.0 * Math.Atan(0.5), 800, 600);

        Assert.True(CraterDisc.Of(new Crater(1, "1", null, 0.0, 0.0, 20e3), 1_737_400.0).TryProject(camera, out ImageEllipse ellipse));

        Assert.Equal(400.5, ellipse.X, Rounding.OfSolutions);
        Assert.Equal(300.5, ellipse.Y, Rounding.OfSolutions);
        Assert.Equal(80.0, ellipse.SemiMajor, Rounding.OfSolutions);
        Assert.Equal(80.0, ellipse.SemiMinor, Rounding.OfSolutions);
    }

    /// <summary>The angle is from east towards north on the ground, so upwards in an image whose north is up.</summary>
    [Fact]
    public void TryProject_EllipseStraightBelow_LiesAsTheCatalogueSays()
    {
        PinholeCamera camera = new(
            new Vector3D(1_837_400.0, 0.0, 0.0), UnitQuaternion.FromComponents(0.0, 0.0, 0.0, 1.0), 2.0 * Math.Atan(0.5), 800, 600);
        Crater crater = new(1, "1", null, 0.0, 0.0, 20e3) { MinorDiameter = 10e3, AngleDegrees = 30.0 };

        Assert.True(CraterDisc.Of(crater, 1_737_400.0).TryProject(camera, out ImageEllipse ellipse));

        Assert.Equal(-30.0, double.RadiansToDegrees(ellipse.Angle), Rounding.OfPlaces);
        Assert.Equal(40.0, ellipse.SemiMinor, Rounding.OfPlaces);
    }

    [Fact]
    public void IsHiddenBy_PointsAboutTheDisc_OnlyThoseAboveItsPlaneAndBesideIt()
    {
        CraterDisc disc = CraterDisc.Of(new Crater(1, "1", null, 0.0, 0.0, 20e3) { MinorDiameter = 10e3 }, 1_737_400.0);

        Assert.False(disc.IsHiddenBy(disc.Centre + new Vector3D(500.0, 9_999.0, 0.0)));
        Assert.True(disc.IsHiddenBy(disc.Centre + new Vector3D(500.0, 10_001.0, 0.0)));
        Assert.True(disc.IsHiddenBy(disc.Centre + new Vector3D(500.0, 0.0, -5_001.0)));
        Assert.False(disc.IsHiddenBy(disc.Centre + new Vector3D(-500.0, 0.0, -5_001.0)));
    }

    /// <summary>Whether the image shows some of a disc, against many points of the disc and many rays of the image.</summary>
    [Fact]
    public void Shows_AnyDisc_AsManyPointsSay()
    {
        (int shown, int doubtful, int all) = (0, 0, 0);
        for (int number = 0; number < TestLength.Of(60, 2000); number++)
        {
            FrameCamera camera = OddCamera(number);
            ImagePyramid pyramid = new(camera);
            foreach (Crater crater in CratersBelow(number + 1000, camera))
            {
                CraterDisc disc = CraterDisc.Of(crater, 1_737_400.0);
                bool shows = pyramid.Shows(disc);
                bool isSeen = PointsOf(disc).Any(point => camera.TryProjectPoint(point, out RenderingPoint at)
                    && at.X > 0.5 && at.X < camera.Width + 0.5 && at.Y > 0.5 && at.Y < camera.Height + 0.5)
                    || RaysOf(camera).Any(ray => Meets(ray, disc));
                Assert.True(shows || !isSeen, $"camera {number}, crater {crater}");
                all++;
                shown += shows ? 1 : 0;
                doubtful += shows && !isSeen ? 1 : 0;
            }
        }

        Assert.InRange(shown, 0.2 * all, 0.9 * all);
        Assert.InRange(doubtful, 0, 0.01 * all); // points and rays are a sample: they miss the narrowest edges
    }

    private static IEnumerable<Vector3D> PointsOf(CraterDisc disc) =>
        from ring in Enumerable.Range(0, 21)
        from place in Enumerable.Range(0, 72)
        select disc.Centre + (0.05 * ring * (disc.RimAt(Math.PI * place / 36.0) - disc.Centre));

    private static IEnumerable<Ray> RaysOf(FrameCamera camera) =>
        from x in Enumerable.Range(0, 33)
        from y in Enumerable.Range(0, 33)
        select camera.RayThrough(0.5 + (x * camera.Width / 32.0), 0.5 + (y * camera.Height / 32.0));

    private static bool Meets(Ray ray, CraterDisc disc)
    {
        double at = Vector3D.Dot(disc.Centre - ray.Origin, disc.Up) / Vector3D.Dot(ray.Direction, disc.Up);
        Vector3D way = ray.Origin + (at * ray.Direction) - disc.Centre;
        double along = Vector3D.Dot(way, disc.Major) / disc.Major.LengthSquared;
        double across = Vector3D.Dot(way, disc.Minor) / disc.Minor.LengthSquared;
        return at > 0.0 && (along * along) + (across * across) <= 1.0;
    }

    /// <summary>A pinhole with a principal point, two focal lengths and a skew of its own.</summary>
    private PinholeCamera OddCamera(int number)
    {
        (PinholeCamera plain, _, _) = CameraCases.Make(number, ldem4.Grid, 20_000);
        CameraModel model = plain.Model;
        double wide = plain.FieldOfView * Math.Max(1.0, (double)model.Height / model.Width);
        return number % 3 == 0 || wide > 1.2 ? plain : (PinholeCamera)new CameraModel(
            model.Width, model.Height, (model.FocalX, 1.2 * model.FocalX), (0.2 * model.Width, 0.9 * model.Height),
            number % 2 * 0.07 * model.FocalX).At(plain.State);
    }

    /// <summary>Craters about the places that the image shows.</summary>
    private static IEnumerable<Crater> CratersBelow(int seed, FrameCamera camera)
    {
        Random random = new(seed);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        for (int i = 0; i < 8; i++)
        {
            Vector3D towards = camera.RayThrough(Between(-0.5, 1.5) * camera.Width, Between(-0.5, 1.5) * camera.Height).Direction;
            double height = camera.PositionBodyFixed.Length - 1_737_400.0;
            Vector3D place = camera.PositionBodyFixed + (Between(0.5, 2.0) * height / towards.Length * towards);
            double diameter = Math.Clamp(height, 1e3, 1e6) * Math.Exp(Between(-4.0, 1.0));
            yield return new Crater(
                i + 1, $"{i + 1}", null, double.RadiansToDegrees(Math.Atan2(place.Z, double.Hypot(place.X, place.Y))),
                double.RadiansToDegrees(Math.Atan2(place.Y, place.X)), diameter)
            {
                MinorDiameter = Between(0.5, 1.0) * diameter,
                AngleDegrees = Between(0.0, 180.0),
            };
        }
    }
}
