using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

/// <summary>The ellipses of rims, against those that an independent search finds for the same points of the image.</summary>
public class RimFitTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const int Width = 320;
    private const int Height = 240;

    /// <summary>px: how well the search finds centre and axes; it ends where sums of squares no longer tell them apart.</summary>
    private const double Found = 2e-3;

    private static readonly CraterCatalogue Catalogue = new(RandomCraters.Make(7, 20_000));

    private static SceneLight Light => new(new Vector3D(1.5e11, 0.0, 1e10), IsSun: true);

    /// <summary>A pinhole sees a disc's rim as an ellipse: the one that fits its points is the projected one.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Find_Pinhole_IsTheEllipseOfItsRim()
    {
        FrameCamera camera = (FrameCamera)Camera(null);
        CraterView[] views = Views(camera, CraterRim.Disc);
        foreach (CraterView view in views)
        {
            RenderingPoint[] rim = [.. Enumerable.Range(0, 64).Select(i =>
            {
                Assert.True(camera.TryProjectPoint(view.Disc.RimAt(2.0 * Math.PI * i / 64.0), out RenderingPoint point));
                return point;
            })];
            double[] fit = LeastSquaresEllipse.Fit(rim, Numbers(view.Ellipse with { X = view.Ellipse.X + 0.3 }));

            Assert.InRange(LeastSquaresEllipse.Residual(rim, Numbers(view.Ellipse)), 0.0, 1e-5); // px: as the search ends
            Assert.Equal(view.Ellipse.X, fit[0], Found);
            Assert.Equal(view.Ellipse.Y, fit[1], Found);
        }
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("lens", CraterRim.Disc)]
    [InlineData("rows", CraterRim.Disc)]
    [InlineData("pinhole", CraterRim.Terrain)]
    [InlineData("lens", CraterRim.Terrain)]
    [InlineData("rows", CraterRim.Terrain)]
    public void Find_RimThatIsNoEllipse_IsFittedByLeastSquaresInTheImage(string kind, CraterRim rim)
    {
        ICamera camera = Camera(kind);
        double largest = 0.0;
        foreach (CraterView view in Views(camera, rim))
        {
            double[] own = Numbers(view.Ellipse);
            double residual = LeastSquaresEllipse.Residual(view.Curve, own);
            double[] fit = LeastSquaresEllipse.Fit(view.Curve, own);
            double best = LeastSquaresEllipse.Residual(view.Curve, fit);

            Assert.Equal(residual, view.Residual!.Value, 1e-6 + (1e-6 * residual));
            Assert.InRange(residual, 0.0, best + 1e-6 + (1e-5 * best));
            Assert.Equal(fit[0], own[0], Found + (0.02 * best));
            Assert.Equal(fit[1], own[1], Found + (0.02 * best));
            Assert.Equal(fit[2] * fit[3], own[2] * own[3], own[2] * (Found + (0.02 * best)) * 2.0);
            largest = Math.Max(largest, residual);
        }

        Assert.InRange(largest, 0.001, 20.0); // px: rims that are no ellipses, and none with a point far away
    }

    /// <summary>Crater, landmark and the points that pixels show lie on the same ground.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Find_CraterAndLandmark_StandOnTheGroundThatIsSeen()
    {
        FrameCamera camera = (FrameCamera)Camera(null);
        TerrainTracer tracer = new(ldem4.Grid);
        List<Crater> craters = [];
        List<Landmark> landmarks = [];
        List<double> radii = [];
        for (int number = 1; number <= 200; number++)
        {
            Assert.True(tracer.TryTrace(camera.RayThrough(1.0 + (number * 1.5), 1.0 + (number * 37 % Height)), out SurfaceHit hit));
            SelenographicPoint place = SelenographicPoint.Below(hit.PointBodyFixed);
            (double latitude, double longitude) = (double.RadiansToDegrees(place.Latitude), double.RadiansToDegrees(place.Longitude));
            string name = $"{number}";
            craters.Add(new Crater(number, name, null, latitude, longitude, 40e3));
            landmarks.Add(new Landmark(number, name, null, hit.PointBodyFixed.Normalized(), null));
            radii.Add(hit.PointBodyFixed.Length);
        }

        CraterView[] seen = [.. new CraterFinder(new CraterCatalogue(craters), CraterRim.Disc, 0.0).Find(camera, Light, ldem4.Grid).Views];
        IReadOnlyList<LandmarkView> marks = new LandmarkFinder(landmarks).Find(camera, Light, ldem4.Grid).Views;

        Assert.Equal((200, 200), (seen.Length, marks.Count));
        for (int index = 0; index < seen.Length; index++)
        {
            // The place of a point is rounded to 1e-9 m on the way through its angles; slopes of the ground are below 1.
            Assert.Equal(radii[index], seen[index].Disc.Centre.Length, 1e-6);
            Assert.Equal(radii[index], marks[index].PointBodyFixed.Length, 1e-6);
        }
    }

    private static double[] Numbers(ImageEllipse ellipse) =>
        [ellipse.X, ellipse.Y, ellipse.SemiMajor, ellipse.SemiMinor, ellipse.Angle];

    /// <summary>Some craters of an image, small and large ones.</summary>
    private CraterView[] Views(ICamera camera, CraterRim rim)
    {
        CraterView[] all = [.. new CraterFinder(Catalogue, rim, 4.0).Find(camera, Light, ldem4.Grid).Views
            .OrderBy(view => view.Ellipse.SemiMajor)];
        int count = TestLength.Of(5, 100);
        CraterView[] some = [.. Enumerable.Range(0, count).Select(i => all[i * (all.Length - 1) / (count - 1)]).Distinct()];
        Assert.InRange(some.Length, 3, count);
        return some;
    }

    /// <summary>300 km over the near side, somewhat aslant.</summary>
    private static ICamera Camera(string? kind)
    {
        CameraModel model = kind == "lens"
            ? LensCases.Of("barrel", 0.6, Width, Height)
            : new CameraModel(Width, Height, (270.0, 260.0), (0.45 * Width, 0.6 * Height), 3.0);
        UnitQuaternion aslant = UnitQuaternion.FromAxisAngle(Vector3D.UnitY, 0.2);
        CameraState state = new(new Vector3D(1_737_400.0 + 300e3, 0.0, 0.0), aslant);
        return kind != "rows" ? model.At(state) : new Scan(ScanKind.RollingShutter, Height, 0.2).CameraOf(
            model, [.. Enumerable.Range(0, Height).Select(row => new CameraState(
                state.PositionBodyFixed + new Vector3D(0.0, 60.0 * row, 30.0 * row),
                aslant * UnitQuaternion.FromAxisAngle(Vector3D.UnitX, 2e-4 * row * Math.Sin(0.05 * row)))
            {
                Seconds = 0.2 * row,
                SunPositionBodyFixed = Light.PositionBodyFixed,
            })]);
    }
}
