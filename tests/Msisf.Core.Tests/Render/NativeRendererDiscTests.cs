using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>The Sun as a disc: each pixel's light against a single ray to each point of the disc.</summary>
public sealed class NativeRendererDiscTests
{
    private const int Side = 160;

    /// <summary>px: 64 rays a pixel take their time.</summary>
    private const int Step = 8;

    private static readonly NativeRenderOptions Disc = new()
    {
        Reflectance = new LambertReflectance(0.64),
        Sun = SunModel.Disc,
        KeepGroundTruth = true,
    };

    [RequiresTheory(Part.Ldem4)]
    [InlineData("far")]
    [InlineData("grazing-sun")]
    [InlineData("north-pole")]
    public void Render_SunAsDisc_SeesWhatSingleRaysSee(string scene)
    {
        MemoryElevationGrid grid = MemoryElevationGrid.Ldem4();
        RenderScenes.RenderSceneCase given = RenderScenes.Named(scene);
        PinholeCamera camera = given.Camera(grid, Side, Side);
        TerrainTracer tracer = new(grid);
        SunDisc disc = new(given.Sun);
        using NativeFrame frame = new NativeRenderer(grid).Render(camera, new SceneLight(given.Sun, IsSun: true), Disc, threads: 2);
        int parts = 0;
        for (int y = 1; y <= Side; y += Step)
        {
            for (int x = 1; x <= Side; x += Step)
            {
                if (!frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
                {
                    continue;
                }

                double visible = 0.0;
                double irradiance = 0.0;
                foreach (Vector3D point in disc.PointsBodyFixed)
                {
                    // Of a facet that turns away from the point the tracer says hidden too.
                    if (!tracer.IsHidden(hit.PointBodyFixed, hit.Facet, point))
                    {
                        visible += 1.0 / SunDisc.Points;
                        irradiance += Math.Cos(Vector3D.AngleBetween(hit.NormalBodyFixed, point - hit.PointBodyFixed)) / SunDisc.Points;
                    }
                }

                Assert.Equal(visible, light.VisibleFraction, 12);
                Assert.Equal(StateOf(visible), light.State is IlluminationState.Night ? IlluminationState.Shadow : light.State);

                // A disc that nothing cuts is as bright as its centre, but for the square of its angular radius.
                Assert.Equal(0.64 * irradiance, frame.RadianceFactors[((y - 1) * Side) + x - 1], 4e-5);
                parts += light.State == IlluminationState.Penumbra ? 1 : 0;
            }
        }

        Assert.InRange(parts, 3, Side * Side / Step / Step / 4);
    }

    private static IlluminationState StateOf(double visible) =>
        visible > 0.99999 ? IlluminationState.Lit : visible > 0.0 ? IlluminationState.Penumbra : IlluminationState.Shadow;
}
