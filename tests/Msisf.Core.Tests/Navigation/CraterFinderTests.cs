using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

/// <summary>Craters of a frame, against all craters of the catalogue taken one by one, and against every pixel of the frame.</summary>
public class CraterFinderTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const int Width = 160;
    private const int Height = 120;

    private static readonly CraterCatalogue Catalogue = new(RandomCraters.Make(7, 20_000));

    /// <summary>The same set as without any search: each crater's disc, its points one by one. Those at a border count in either.</summary>
    [Fact]
    public void Find_AnyScene_HasTheCratersThatAreFoundOneByOne()
    {
        int found = 0;
        int step = TestLength.Of(16, 1);
        string[] everyday = ["far", "oblique-20km", "north-pole-axis", "half-sky", "wide-angle", "whole-disc", "limb-1e9"];
        int count = TestLength.Of(everyday.Length, RenderScenes.All.Count);
        foreach (RenderScenes.RenderSceneCase scene in
            RenderScenes.All.OrderBy(scene => everyday.Contains(scene.Name) ? 0 : 1).Take(count))
        {
            PinholeCamera camera = scene.Camera(ldem4.Grid, Width, Height);
            CratersOfFrame craters = new CraterFinder(Catalogue, CraterRim.Disc, 0.0).Find(camera, Light(scene), ldem4.Grid);
            Dictionary<int, CraterView> views = craters.Views.ToDictionary(view => view.Crater.Number);
            HashSet<int> leftOut = [.. craters.LeftOut.Select(crater => crater.Crater.Number)];
            foreach (Crater crater in Catalogue.Craters.Where((_, index) => index % step == 0))
            {
                CraterDisc disc = CraterDisc.Of(crater, new GroundBelow(ldem4.Grid).RadiusAt(CraterDisc.Of(crater, 1.0).Up));
                bool isThere = views.ContainsKey(crater.Number) || leftOut.Contains(crater.Number);
                if (Vector3D.Dot(camera.PositionBodyFixed, disc.Up) <= disc.Centre.Length)
                {
                    Assert.False(isThere);
                    continue;
                }

                bool isSeen = ByPoints(camera, disc);
                bool isAtBorder = disc.TryProject(camera, out ImageEllipse of)
                    && (of.AreaInside(Width, Height) < 0.03 * of.Area || of.Area > Width * Height);
                Assert.True(isThere == isSeen || (isThere && isAtBorder), $"{scene.Name}, {crater}");
                if (views.TryGetValue(crater.Number, out CraterView? view))
                {
                    found++;
                    RenderingPoint rim = default;
                    Assert.True(camera.TryProjectPoint(disc.RimAt(1.0), out rim));
                    Assert.InRange(
                        view.Ellipse.DistanceTo(rim.X, rim.Y), 0.0, Rounding.OfPlaces * Math.Max(1.0, 100.0 / view.Ellipse.SemiMinor));
                    double normal = Vector3D.AngleBetween(disc.Up, camera.PositionBodyFixed - disc.Centre);
                    Assert.Equal(normal, view.Emission, Rounding.OfChains);
                }
            }
        }

        Assert.True(found > 500 / step, $"{found} craters");
    }

    /// <summary>Smaller craters are counted, not listed.</summary>
    [Fact]
    public void Find_LeastDiameter_CountsSmallerOnes()
    {
        PinholeCamera camera = RenderScenes.Named("far").Camera(ldem4.Grid, Width, Height);
        SceneLight light = Light(RenderScenes.Named("far"));

        CratersOfFrame all = new CraterFinder(Catalogue, CraterRim.Disc, 0.0).Find(camera, light, ldem4.Grid);
        CratersOfFrame large = new CraterFinder(Catalogue, CraterRim.Disc, 4.0).Find(camera, light, ldem4.Grid);

        Assert.Equal(all.Views.Where(view => view.Diameter >= 4.0).Select(view => view.Crater), large.Views.Select(view => view.Crater));
        Assert.Equal(all.Views.Count - large.Views.Count, large.TooSmall);
        Assert.InRange(large.TooSmall, 1, all.Views.Count - 1);
    }

    /// <summary>Through each lens the rim is the listed curve, near the ellipse where the lens is nearly a pinhole.</summary>
    [Fact]
    public void Find_Lens_GivesCurveAndEllipseThatFits()
    {
        PinholeCamera pinhole = RenderScenes.Named("far").Camera(ldem4.Grid, Width, Height);
        CameraState state = new(pinhole.PositionBodyFixed, pinhole.MoonFromCamera);
        foreach (string lens in LensCases.Names)
        {
            FrameCamera camera = LensCases.Of(lens, 0.3, Width, Height).At(state);
            CratersOfFrame craters = new CraterFinder(Catalogue, CraterRim.Disc, 6.0).Find(
                camera, Light(RenderScenes.Named("far")), ldem4.Grid);
            Assert.NotEmpty(craters.Views);
            bool hasLens = camera.Model.Distortion is not null;
            foreach (CraterView view in craters.Views)
            {
                Assert.Equal(hasLens, view.Curve.Count > 0);
                RenderingPoint point = default;
                Assert.True(camera.TryProjectPoint(view.Disc.RimAt(0.5 * Math.PI), out point));
                double distance = view.Ellipse.DistanceTo(point.X, point.Y);
                Assert.InRange(distance, 0.0, hasLens ? Math.Max(1e-6, 4.0 * view.Residual!.Value) : 1e-9);
                if (hasLens)
                {
                    Assert.Equal(point, view.Curve[view.Curve.Count / 4]);
                    // the lenses bend a rim less than that off an ellipse
                    Assert.InRange(view.Residual!.Value, 0.0, 0.02 * view.Diameter);
                }
            }
        }
    }

    /// <summary>Hidden and lit parts of craters of up to 200 pixels, against every pixel; larger ones to 0.07.</summary>
    [Theory]
    [InlineData("far")]
    [InlineData("oblique-20km")]
    [InlineData("limb")]
    public void WithParts_AnyScene_AreThoseOfEveryPixel(string name)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        PinholeCamera camera = scene.Camera(ldem4.Grid, Width, Height);
        SceneLight light = Light(scene);
        using NativeFrame frame = new NativeRenderer(ldem4.Grid).Render(
            camera, light, new NativeRenderOptions { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true }, threads: 2);
        CratersOfFrame craters = CraterPixels.WithParts(new CraterFinder(Catalogue, CraterRim.Disc, 3.0).Find(
            camera, light, ldem4.Grid), frame);
        int[] numbers = CraterPixels.NumbersOf(craters, frame, threads: 2);
        int[] expected = new int[Width * Height];
        TerrainTracer tracer = new(ldem4.Grid);
        foreach (CraterView view in craters.Views.OrderByDescending(view => view.Ellipse.Area))
        {
            (int all, int hidden, int shown, double lit) = (0, 0, 0, 0.0);
            for (int y = 1; y <= Height; y++)
            {
                for (int x = 1; x <= Width; x++)
                {
                    (double u, double v) = view.Ellipse.ToUnitCircle(x, y);
                    if ((u * u) + (v * v) > 1.0)
                    {
                        continue;
                    }

                    all++;
                    if (!tracer.TryTrace(camera.RayThrough(x, y), out SurfaceHit hit))
                    {
                        continue;
                    }

                    bool isHidden = Vector3D.Dot(hit.PointBodyFixed - view.Disc.Centre, view.Disc.Up) > 0.0
                        && IsBeside(hit.PointBodyFixed, view);
                    hidden += isHidden ? 1 : 0;
                    if (!isHidden)
                    {
                        shown++;
                        lit += tracer.IsHidden(hit.PointBodyFixed, hit.Facet, light.PositionBodyFixed) ? 0.0 : 1.0;
                        expected[((y - 1) * Width) + x - 1] = view.Crater.Number;
                    }
                }
            }

            double error = all < 200 ? 1e-12 : 0.07;
            if (all > 0)
            {
                Assert.Equal((double)hidden / all, view.Hidden!.Value, error);
            }

            if (shown > 0)
            {
                Assert.Equal(lit / shown, view.Lit!.Value, Math.Max(error, 1.0 / shown)); // a pixel at a shadow's edge may go either way
            }
        }

        Assert.Equal(expected, numbers);
    }

    private static bool IsBeside(Vector3D point, CraterView view)
    {
        Vector3D way = point - view.Disc.Centre;
        double along = Vector3D.Dot(way, view.Disc.Major.Normalized()) / (0.5 * view.Crater.Diameter);
        double across = Vector3D.Dot(way, view.Disc.Minor.Normalized()) / (0.5 * view.Crater.MinorDiameter);
        return double.Hypot(along, across) > 1.0;
    }

    private static bool ByPoints(PinholeCamera camera, CraterDisc disc)
    {
        for (int ring = 0; ring <= 8; ring++)
        {
            for (int place = 0; place < 48; place++)
            {
                Vector3D point = disc.Centre + (0.125 * ring * (disc.RimAt(Math.PI * place / 24.0) - disc.Centre));
                if (camera.TryProjectPoint(point, out RenderingPoint at)
                    && at.X > 0.5 && at.X < Width + 0.5 && at.Y > 0.5 && at.Y < Height + 0.5)
                {
                    return true;
                }
            }
        }

        return false;
    }

    private static SceneLight Light(RenderScenes.RenderSceneCase scene) => new(scene.Sun, IsSun: true);
}
