using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Surface;
using Msisf.Core.Render.Tracing;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>No ray slips between two facets.</summary>
public sealed class WatertightTests
{
    private const int Views = 10_000;

    private const int Pixels = 1024;

    [Fact]
    public void Run_TenThousandViews_HaveNoHoles()
    {
        // Coarse enough that a view of the whole Moon takes a moment; facets of all sizes come with the cameras' distances.
        IElevationGrid rough = FunctionGrid.Rough(1);
        MemoryElevationGrid grid = new("ROUGH", 1, (line, sample) => RadiusOf(rough, line, sample));
        TerrainTracer tracer = new(grid);
        VisibilityPass pass = new(new SurfaceModel(grid));
        List<string> holes = [];
        long surface = 0;
        for (int number = 0; number < Views; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, grid, Pixels);
            VisibleSurface seen = pass.Run(camera, 2, CancellationToken.None);
            for (int y = 1; y <= camera.Height; y++)
            {
                for (int x = 1; x <= camera.Width; x++)
                {
                    bool isSeen = IsSeen(seen, x, y);
                    surface += isSeen ? 1 : 0;
                    if (!isSeen && IsSuspect(seen, camera, x, y) && tracer.TryTrace(camera.RayThrough(x, y), out _))
                    {
                        holes.Add($"view {number} ({kind}), pixel ({x}, {y})");
                    }
                }
            }
        }

        Assert.True(holes.Count == 0, $"{holes.Count} holes: {string.Join(", ", holes.Take(10))}");
        Assert.InRange(surface, 3_000_000, 9_000_000);
    }

    /// <summary>A pixel that is surely on the disc, or that has the surface on all four sides.</summary>
    private static bool IsSuspect(VisibleSurface seen, PinholeCamera camera, int x, int y) =>
        IsOnDisc(camera.RayThrough(x, y))
        || (IsSeen(seen, x - 1, y) && IsSeen(seen, x + 1, y) && IsSeen(seen, x, y - 1) && IsSeen(seen, x, y + 1));

    private static bool IsOnDisc(Ray ray)
    {
        const double Below = 1_737_400.0 - 5_100.0; // no radius of the model is less, nor are its facets' middles
        double along = -Vector3D.Dot(ray.Origin, ray.Direction) / ray.Direction.LengthSquared;
        return along > 0.0 && (ray.Origin + (along * ray.Direction)).Length < Below;
    }

    private static bool IsSeen(VisibleSurface seen, int x, int y) =>
        x >= 1 && y >= 1 && x <= seen.Width && y <= seen.Height && seen.TryGet(x, y, out _);

    private static double RadiusOf(IElevationGrid grid, int line, int sample)
    {
        Span<double> radius = stackalloc double[1];
        grid.ReadRadii(line, sample, radius);
        return radius[0];
    }
}
