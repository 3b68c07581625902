using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>Parts of cylindrical models: the same facets as those of the whole Moon, and the renderer against the tracer.</summary>
public sealed class WindowSceneTests
{
    private const int Side = 150;

    private static readonly FunctionGrid Moon = FunctionGrid.Rugged(4);
    private static readonly NativeRenderOptions Options =
        new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true, Normals = NormalModel.Smooth };

    /// <summary>A band of +-60 degrees, a rectangle, and one across the prime meridian.</summary>
    public static TheoryData<int, int, int, int> Windows => new()
    {
        { 120, 600, 0, 1440 }, { 200, 320, 100, 260 }, { 200, 320, 1360, 1520 },
    };

    /// <summary>Camera over the prime meridian or over the rectangle's middle; the second also sees the northern border.</summary>
    public static TheoryData<int, int, int, int, double, double, double, double> Views => new()
    {
        { 120, 600, 0, 1440, 10.0, 0.0, 300e3, 0.0 },
        { 120, 600, 0, 1440, 50.0, 200.0, 200e3, 50.0 },
        { 200, 320, 100, 260, 24.0, 45.0, 300e3, 0.0 },
        { 200, 320, 100, 260, 30.0, 40.0, 500e3, 30.0 },
        { 200, 320, 1360, 1520, 24.0, 2.0, 300e3, 0.0 },
        { 200, 320, 1360, 1520, 30.0, 359.0, 500e3, 30.0 },
    };

    [Theory]
    [MemberData(nameof(Windows))]
    public void Trace_StraightDown_HitsTheFacetOfTheWholeMoon(int firstLine, int endLine, int firstSample, int endSample)
    {
        GridWindow window = new(firstLine, endLine, firstSample, endSample);
        TerrainTracer part = new(new WindowGrid(Moon, window));
        TerrainTracer whole = new(Moon);
        Random random = new(20120222);
        int inside = 0;
        for (int number = 0; number < 500; number++)
        {
            double line = firstLine - 5 + ((window.Lines + 10) * random.NextDouble());
            double sample = firstSample - 5 + ((window.Samples + 10) * random.NextDouble());
            Vector3D direction = ((ITerrainGrid)Moon).Projection.DirectionOf(line, sample);
            Ray down = new(1.8e6 * direction, -direction);
            Assert.True(whole.TryTrace(down, out SurfaceHit expected));
            FacetId facet = expected.Facet;
            facet = facet with { Sample = facet.Sample + (facet.Sample + 1440 < endSample ? 1440 : 0) };
            bool isInside = facet.Line >= firstLine && facet.Line < endLine - 1
                && (window.Samples == 1440 || (facet.Sample >= firstSample && facet.Sample < endSample - 1));
            Assert.Equal(isInside, part.TryTrace(down, out SurfaceHit hit));
            Assert.Equal(isInside ? expected with { Facet = facet } : default, hit);
            inside += isInside ? 1 : 0;
        }

        Assert.InRange(inside, 300, 499);
    }

    [Theory]
    [MemberData(nameof(Views))]
    public void Render_Part_IsAsTraced(
        int firstLine, int endLine, int firstSample, int endSample, double latitude, double longitude, double height, double tilt)
    {
        WindowGrid grid = new(Moon, new GridWindow(firstLine, endLine, firstSample, endSample));
        RenderScenes.RenderSceneCase scene = new("part", latitude, longitude, height, tilt, 0.0, 60.0, 12.0, 80.0);
        PinholeCamera camera = scene.Camera(grid, Side, Side);
        SceneLight sun = new(scene.Sun, IsSun: true);
        using NativeFrame drawn = new NativeRenderer(grid).Render(camera, sun, Options, threads: 2);
        TracedFrameTruth traced = new(camera, sun, new TerrainTracer(grid));
        int surface = 0;
        for (int pixel = 0; pixel < Side * Side; pixel += 3)
        {
            (int x, int y) = ((pixel % Side) + 1, (pixel / Side) + 1);
            bool isSurface = traced.TryGet(x, y, out SurfaceHit expected, out PixelIllumination expectedLight);
            Assert.Equal(isSurface, drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light));
            Assert.Equal(expected.Facet, hit.Facet);
            Assert.Equal(expectedLight, light);
            surface += isSurface ? 1 : 0;
        }

        Assert.InRange(surface, 1000, Side * Side / 3);
        Assert.Equal(tilt == 0.0, surface == Side * Side / 3);
    }
}
