using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

/// <summary>Landmarks against points of the drawn surface, differences of projections and sight over a hill of known height.</summary>
public class LandmarkFinderTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const int Width = 160;
    private const int Height = 120;

    /// <summary>A point that a pixel shows is a landmark of the terrain there, of this height, visible, and of this position.</summary>
    [Fact]
    public void Find_PointsThatPixelsShow_AreSeenThereAndVisible()
    {
        TerrainTracer tracer = new(ldem4.Grid);
        int found = 0;
        foreach (string name in (string[])["far", "oblique-20km", "north-pole-axis", "wide-angle"])
        {
            RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
            PinholeCamera camera = scene.Camera(ldem4.Grid, Width, Height);
            SceneLight sun = new(scene.Sun, IsSun: true);
            Random random = new(20120222);
            for (int i = 0; i < TestLength.Of(40, 2000); i++)
            {
                double x = 0.5 + (Width * random.NextDouble());
                double y = 0.5 + (Height * random.NextDouble());
                if (!tracer.TryTrace(camera.RayThrough(x, y), out SurfaceHit hit))
                {
                    continue;
                }

                found++;
                LandmarkView onTerrain = One(new Landmark(1, "1", null, hit.PointBodyFixed.Normalized(), null), camera, sun);
                double scale = camera.Model.FocalX / Vector3D.Dot(hit.PointBodyFixed - camera.PositionBodyFixed, camera.ForwardBodyFixed);
                Assert.Equal(x, onTerrain.X, 1e-9 + (1e-8 * scale));
                Assert.Equal(y, onTerrain.Y, 1e-9 + (1e-8 * scale));
                Assert.Null(onTerrain.HiddenBy);
                Assert.Equal(!tracer.IsHidden(hit.PointBodyFixed, hit.Facet, scene.Sun), onTerrain.IsLit);
                Assert.Equal(
                    Vector3D.AngleBetween(hit.NormalBodyFixed, scene.Sun - hit.PointBodyFixed), onTerrain.Incidence!.Value,
                    Rounding.OfPlaces);
                double range = (hit.PointBodyFixed - camera.PositionBodyFixed).Length;
                Assert.Equal(range, onTerrain.Range, 1e-7 * range); // the direction in space is found again from latitude and longitude

                // A point below the ground is hidden by the facet that the pixel shows, where it is seen at the same place.
                Vector3D below = hit.PointBodyFixed + (100.0 / range * (hit.PointBodyFixed - camera.PositionBodyFixed));
                LandmarkView deep = One(
                    new Landmark(1, "1", null, below.Normalized(), below.Length - 1_737_400.0), camera, sun);
                Assert.Equal(hit.Facet, deep.HiddenBy);
                Assert.False(deep.IsLit);
            }
        }

        Assert.True(found > 80, $"{found} points");
    }

    [Fact]
    public void Find_PointsOutsideTheImage_AreCounted()
    {
        PinholeCamera camera = RenderScenes.Named("nadir-100km").Camera(ldem4.Grid, Width, Height);

        LandmarksOfFrame found = new LandmarkFinder(
        [
            new Landmark(1, "here", null, camera.PositionBodyFixed.Normalized(), null),
            new Landmark(2, "behind", null, camera.PositionBodyFixed.Normalized(), 1e6),
            new Landmark(3, "antipode", null, -camera.PositionBodyFixed.Normalized(), 3e6),
        ]).Find(camera, new SceneLight(new Vector3D(1.5e11, 0.0, 0.0), IsSun: true), ldem4.Grid);

        Assert.Equal(["here", "antipode"], found.Views.Select(view => view.Landmark.Identity));
        Assert.NotNull(found.Views[1].HiddenBy); // straight below, but on the other side
        Assert.Equal(1, found.Outside);
        Assert.Equal(0.5 * (Width + 1), found.Views[0].X, 1e-6);
    }

    /// <summary>Of all lenses, against Richardson's differences of projections by cameras that were moved and turned.</summary>
    [Fact]
    public void Derivatives_EachLens_AreThoseOfDifferences()
    {
        foreach (string lens in LensCases.Names.Append("pinhole"))
        {
            PinholeCamera at = RenderScenes.Named("oblique-20km").Camera(ldem4.Grid, Width, Height);
            CameraModel model = lens == "pinhole" ? at.Model : LensCases.Of(lens, 0.4, Width, Height);
            FrameCamera camera = model.At(new CameraState(at.PositionBodyFixed, at.MoonFromCamera));
            Vector3D point = camera.PositionBodyFixed + (30e3 * camera.RayThrough(0.2 * Width, 0.3 * Height).Direction.Normalized());

            PixelDerivatives found = PixelDerivatives.At(camera, point);

            Vector3D[] axes = [Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ];
            double largest = 0.0;
            for (int axis = 0; axis < axes.Length; axis++)
            {
                Vector3D along = axes[axis];
                Vector3D shift = camera.MoonFromCamera * along;
                Check(by => Seen(model, camera.PositionBodyFixed + (by * shift), camera.MoonFromCamera, point), 200.0,
                    Part(found.XByShift, axis), Part(found.YByShift, axis), lens);
                Check(by => Seen(model, camera.PositionBodyFixed, camera.MoonFromCamera * Turn(along, by), point), 0.01,
                    Part(found.XByTurn, axis), Part(found.YByTurn, axis), lens);
                Check(by => Seen(model, camera.PositionBodyFixed, camera.MoonFromCamera, point + (by * along)), 200.0,
                    Part(found.XByPoint, axis), Part(found.YByPoint, axis), lens);
                largest = Math.Max(largest, Math.Abs(Part(found.XByTurn, axis)));
            }

            Assert.True(largest > 50.0, "a radian is many pixels");
        }
    }

    private static void Check(Func<double, RenderingPoint> seen, double step, double x, double y, string lens)
    {
        Assert.Equal(Richardson(by => seen(by).X, step), x, Math.Max(1e-9 * Math.Abs(x), 1e-9 / step));
        Assert.True(double.IsFinite(y), lens);
        Assert.Equal(Richardson(by => seen(by).Y, step), y, Math.Max(1e-9 * Math.Abs(y), 1e-9 / step));
    }

    /// <summary>Central differences with steps h, h/2, h/4 ..., extrapolated to 0.</summary>
    private static double Richardson(Func<double, double> of, double step)
    {
        const int orders = 5;
        double[] row = [.. Enumerable.Range(0, orders).Select(i =>
        {
            double h = step / (1 << i);
            return (of(h) - of(-h)) / (2.0 * h);
        })];
        for (int order = 1; order < orders; order++)
        {
            double factor = Math.Pow(4.0, order);
            for (int i = orders - 1; i >= order; i--)
            {
                row[i] = ((factor * row[i]) - row[i - 1]) / (factor - 1.0);
            }
        }

        return row[^1];
    }

    private static RenderingPoint Seen(CameraModel model, Vector3D position, UnitQuaternion attitude, Vector3D point)
    {
        Assert.True(model.At(new CameraState(position, attitude)).TryProjectPoint(point, out RenderingPoint seen));
        return seen;
    }

    private static UnitQuaternion Turn(Vector3D axis, double angle)
    {
        (double sin, double cos) = Math.SinCos(0.5 * angle);
        return UnitQuaternion.FromComponents(sin * axis.X, sin * axis.Y, sin * axis.Z, cos);
    }

    private static double Part(Vector3D vector, int axis) => axis switch
    {
        0 => vector.X,
        1 => vector.Y,
        _ => vector.Z,
    };

    private LandmarkView One(Landmark landmark, ICamera camera, SceneLight light) =>
        Assert.Single(new LandmarkFinder([landmark]).Find(camera, light, ldem4.Grid).Views);
}
