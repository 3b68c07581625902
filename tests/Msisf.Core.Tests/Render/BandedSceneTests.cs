using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Lod;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Preview;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>
/// Frames of cameras whose rows have times and places of their own: each pixel is what the exact tracer finds with its row's state, and
/// each row is the row of a still image in that state.
/// </summary>
public sealed class BandedSceneTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private const int Width = 50;
    private const int Height = 40;

    /// <summary>m: as for frames of one state (<see cref="NativeRendererSceneTests"/>).</summary>
    private const double SamePoint = 1e-7;

    /// <summary>s from row to row; each state is that of two rows.</summary>
    private const double LinePeriod = 0.02;

    private static readonly CameraMotion Motion = new(new Vector3D(900.0, -1200.0, 700.0), new Vector3D(0.1, -0.08, 0.06));

    private static readonly LayerProvenance Provenance = new("RUGGED", 16, 0, "native", SpectralBand.Default);

    [Theory]
    [InlineData("oblique-20km", null, true)]
    [InlineData("oblique-20km", "barrel", true)]
    [InlineData("oblique-20km", "principal-point", false)]
    [InlineData("limb", null, true)]
    [InlineData("grazing-sun", "fisheye", true)]
    [InlineData("across-pole", null, true)]
    [InlineData("one-metre", null, false)]
    public void Render_RowsWithStatesOfTheirOwn_AreAsTracedAndAsInStillImages(string name, string? lens, bool isSun)
    {
        Scanned scene = new(name, lens, rugged.Grid, isSun);
        TerrainTracer tracer = new(rugged.Grid);
        NativeRenderer renderer = new(rugged.Grid);
        NativeRenderOptions options = new() { KeepGroundTruth = true, Reflectance = new LunarLambertReflectance(0.4, 0.12) };
        Layer[] layers = [.. LayerSet.OfAnyFrame.Layers];
        int planes = layers.Sum(layer => layer.Planes);
        Assert.Equal(Height / 2, scene.Camera.Bands.Count);

        using NativeFrame drawn = renderer.Render(scene.Camera, scene.Light, options, threads: 2);
        TracedFrameTruth traced = new(scene.Camera, scene.Light, tracer);
        LayerSampler sampler = new(drawn, Provenance);
        int hits = 0;
        for (int y = 1; y <= Height; y++)
        {
            (FrameCamera still, SceneLight light) = scene.StillOf(y);
            using NativeFrame stillDrawn = renderer.Render(still, light, options, threads: 2);
            double[][] row = Sample(sampler, y, layers, planes);
            double[][] stillRow = Sample(new LayerSampler(stillDrawn, Provenance), y, layers, planes);
            for (int plane = 0; plane < planes; plane++)
            {
                for (int column = 0; column < Width; column++)
                {
                    double scale = Math.Max(1.0, Math.Abs(stillRow[plane][column]));
                    Assert.Equal(stillRow[plane][column] / scale, row[plane][column] / scale, SamePoint);
                }
            }

            for (int x = 1; x <= Width; x++)
            {
                Ray ray = scene.Camera.RayThrough(x, y);
                Assert.Equal(still.PositionBodyFixed, ray.Origin);
                Assert.InRange(Vector3D.AngleBetween(still.RayThrough(x, y).Direction, ray.Direction), 0.0, 1e-15); // some last digits of 1
                bool isHit = tracer.TryTrace(ray, out SurfaceHit expected);
                Assert.Equal(isHit, drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination seen));
                Assert.Equal(isHit, traced.TryGet(x, y, out SurfaceHit tracedHit, out PixelIllumination tracedLight));
                Assert.Equal(expected, tracedHit);
                Assert.Equal(expected.Facet, hit.Facet);
                Assert.InRange((hit.PointBodyFixed - expected.PointBodyFixed).Length, 0.0, SamePoint);
                bool isDark = isHit && isSun && tracer.IsHidden(expected.PointBodyFixed, expected.Facet, light.PositionBodyFixed);
                PixelIllumination lit = isHit ? PixelIllumination.At(expected.PointBodyFixed, isDark ? 0.0 : 1.0, light) : default;
                Assert.Equal(lit, seen);
                Assert.Equal(lit, tracedLight);
                hits += isHit ? 1 : 0;
            }
        }

        Assert.InRange(hits, Width * Height / 8, Width * Height);
    }

    [Fact]
    public void Sample_MetaFileOfRows_IsThatOfStillImages()
    {
        Scanned scene = new("oblique-20km", "barrel", rugged.Grid, isSun: true);
        NativeRenderer renderer = new(rugged.Grid);
        NativeRenderOptions options = new() { KeepGroundTruth = true, Reflectance = new LambertReflectance(0.64) };
        PixelGrid grid = new(Width, Height, 1, 7);
        using NativeFrame drawn = renderer.Render(scene.Camera, scene.Light, options, threads: 2);
        PixelRecord[] records = [.. new PixelSampler(grid, drawn, 16).Sample()];
        PixelRecord[] sphere = [.. new PixelSampler(scene.Camera, grid, ReferenceSphere.Lola, scene.Light).Sample()];
        Assert.Equal(Width * grid.Rows, records.Length);
        foreach (int y in records.Select(record => record.V).Distinct())
        {
            (FrameCamera still, SceneLight light) = scene.StillOf(y);
            using NativeFrame stillDrawn = renderer.Render(still, light, options, threads: 2);
            AssertSame(new PixelSampler(grid, stillDrawn, 16).Sample(), records, y);
            AssertSame(new PixelSampler(still, grid, ReferenceSphere.Lola, light).Sample(), sphere, y);
        }
    }

    /// <summary>The share of the image counted by rays, some for each pixel.</summary>
    [Theory]
    [InlineData("half-sky", null)]
    [InlineData("whole-disc", "principal-point")]
    [InlineData("disc-1e9", null)]
    public void Of_PreviewOfRows_IsWhatTheirRaysMeet(string name, string? lens)
    {
        Scanned scene = new(name, lens, rugged.Grid, isSun: true);
        foreach (ICamera camera in (ICamera[])[scene.Camera, scene.StillOf(1).Camera])
        {
            FramePreview preview = FramePreview.Of(camera, scene.Light, terrain: null);
            const int Part = 4;
            (int seen, int lit) = (0, 0);
            for (int i = 0; i < Part * Width * Part * Height; i++)
            {
                double y = 0.5 + ((i / (Part * Width)) + 0.5) / Part;
                Ray ray = camera.RayThrough(0.5 + (((i % (Part * Width)) + 0.5) / Part), y);
                bool isSeen = ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point);
                seen += isSeen ? 1 : 0;
                lit += isSeen && Vector3D.Dot(point, scene.Light.At(camera, y).PositionBodyFixed - point) > 0.0 ? 1 : 0;
            }

            Assert.InRange(seen, 1, (Part * Part * Width * Height) - 1);
            // the preview takes a sample of the pixels
            Assert.Equal(seen / (double)(Part * Part * Width * Height), preview.Share.Moon, 5e-3);
            Assert.Equal(lit / (double)seen, preview.Share.Lit!.Value, 5e-3); // the same
        }
    }

    [Fact]
    public void For_RowsAtSeveralHeights_IsTheLevelOfTheLowest()
    {
        CameraModel model = CameraModel.FromFieldOfView(0.5, 20, 2);
        CameraState At(double height) => new((height + MoonConstants.ReferenceRadius) * Vector3D.UnitX, UnitQuaternion.Identity);
        LodLevels levels = LodLevels.Open(rugged.Grid);
        ModelDetail detail = new(levels, 0.5);
        ITerrain low = detail.For(model.At(At(50e3)), 1);
        ITerrain high = detail.For(model.At(At(5e6)), 1);

        Assert.NotSame(low, high);
        Assert.Same(low, detail.For(BandedCamera.Of(model, [At(5e6), At(50e3)]), 1));
        Assert.Same(low, detail.For(BandedCamera.Of(model, [At(50e3), At(5e6)]), 1));
    }

    private static void AssertSame(IEnumerable<PixelRecord> still, PixelRecord[] records, int y)
    {
        foreach ((PixelRecord expected, PixelRecord record) in still.Where(record => record.V == y)
            .Zip(records.Where(record => record.V == y)))
        {
            Assert.Equal(expected.H, record.H);
            Assert.Equal(expected.Point.Latitude, record.Point.Latitude, Rounding.OfChains);
            Assert.Equal(expected.Point.Longitude, record.Point.Longitude, Rounding.OfChains);
            Assert.Equal(expected.IlluminationDirection!.Value, record.IlluminationDirection!.Value, Rounding.OfPlaces);
            Assert.Equal(expected.Terrain?.Facet, record.Terrain?.Facet);
            Assert.Equal(expected.Terrain?.Light, record.Terrain?.Light);
        }
    }

    private static double[][] Sample(LayerSampler sampler, int y, Layer[] layers, int planes)
    {
        double[][] row = [.. Enumerable.Range(0, planes).Select(_ => new double[Width])];
        sampler.SampleRow(y - 1, layers, row, 0);
        return row;
    }

    /// <summary>A scene seen by a camera that flies and tumbles while its rows are exposed; the Sun moves too.</summary>
    private sealed class Scanned
    {
        private readonly CameraModel _model;
        private readonly CameraState[] _states;

        public Scanned(string name, string? lens, ITerrain terrain, bool isSun)
        {
            RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
            PinholeCamera still = scene.Camera(terrain, Width, Height);
            _model = lens is null ? still.Model : LensCases.Of(lens, Math.Tan(0.5 * still.FieldOfView), Width, Height);
            Vector3D up = still.PositionBodyFixed.Normalized();
            CameraMotion motion = Motion with { VelocityBodyFixed = Motion.VelocityBodyFixed + (4000.0 * up) }; // never into the ground
            _states = [.. Enumerable.Range(0, Height).Select(row =>
            {
                double seconds = row / 2 * LinePeriod;
                UnitQuaternion turn = UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, 0.1 * seconds);
                return motion.Moved(still.State, seconds) with { SunPositionBodyFixed = turn * scene.Sun };
            })];
            Light = new SceneLight(isSun ? scene.Sun : still.PositionBodyFixed, isSun);
            Camera = BandedCamera.Of(_model, _states);
        }

        public ICamera Camera { get; }

        public SceneLight Light { get; }

        /// <summary>The camera and the light of a row, as those of a whole image.</summary>
        public (FrameCamera Camera, SceneLight Light) StillOf(int y) => (
            _model.At(_states[y - 1]),
            Light with { PositionBodyFixed = Light.IsSun ? _states[y - 1].SunPositionBodyFixed!.Value : _states[y - 1].PositionBodyFixed });
    }
}
