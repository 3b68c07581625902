using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Benchmarks.Measures;

/// <summary>How many of a frame's pixels the exact tracer sees otherwise: a time without its error says little.</summary>
internal sealed record TracerCheck(int Pixels, int OtherFacets, int OtherLight, double LargestDistance)
{
    private const int Seed = 20120222;

    /// <summary>Compares random pixels.</summary>
    /// <param name="frame">Drawn with its truth.</param>
    /// <param name="light">The frame's.</param>
    /// <param name="grid">The level of the model that was drawn.</param>
    /// <param name="pixels">How many.</param>
    public static TracerCheck Of(IGroundTruth frame, SceneLight light, ITerrainGrid grid, int pixels)
    {
        TracedFrameTruth exact = new(frame.Camera, light, new TerrainTracer(grid));
        Random random = new(Seed);
        int facets = 0;
        int lights = 0;
        double distance = 0.0;
        for (int i = 0; i < pixels; i++)
        {
            int x = random.Next(1, frame.Camera.Width + 1);
            int y = random.Next(1, frame.Camera.Height + 1);
            bool isDrawn = frame.TryGet(x, y, out SurfaceHit drawn, out PixelIllumination drawnLight);
            bool isTraced = exact.TryGet(x, y, out SurfaceHit traced, out PixelIllumination tracedLight);
            if (isDrawn != isTraced || drawn.Facet != traced.Facet)
            {
                facets++;
            }
            else
            {
                distance = Math.Max(distance, (drawn.PointBodyFixed - traced.PointBodyFixed).Length);
            }

            if (IsLit(drawnLight) != IsLit(tracedLight))
            {
                lights++;
            }
        }

        return new TracerCheck(pixels, facets, lights, distance);
    }

    private static bool IsLit(PixelIllumination light) => light.State == IlluminationState.Lit;
}
