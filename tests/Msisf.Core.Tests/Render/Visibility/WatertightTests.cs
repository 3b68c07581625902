using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>No ray slips between two facets.</summary>
public sealed class WatertightTests
{
    private static readonly int Views = TestLength.Of(1_000, 10_000);

    private const int Pixels = 1024;

    [Fact]
    public void Run_ThousandsOfViews_HaveNoHoles()
    {
        // Coarse enough that a view of the whole Moon takes a moment; facets of all sizes come with the cameras' distances.
        MemoryElevationGrid grid = MemoryElevationGrid.Of(FunctionGrid.Rough(1));
        TerrainTracer tracer = new(grid);
        VisibilityPass pass = new(new SurfaceModel(grid));
        List<string> holes = [];
        long surface = 0;
        for (int number = 0; number < Views; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, grid, Pixels);
            bool[,] seen = PixelsOf(pass.Run(camera, 2, CancellationToken.None));
            for (int y = 1; y <= camera.Height; y++)
            {
                for (int x = 1; x <= camera.Width; x++)
                {
                    surface += seen[x, y] ? 1 : 0;
                    if (!seen[x, y] && IsSuspect(seen, camera, x, y) && tracer.TryTrace(camera.RayThrough(x, y), out _))
                    {
                        holes.Add($"view {number} ({kind}), pixel ({x}, {y})");
                    }
                }
            }
        }

        Assert.True(holes.Count == 0, $"{holes.Count} holes: {string.Join(", ", holes.Take(10))}");
        Assert.InRange(surface, 300 * Views, 900 * Views);
    }

    /// <summary>By x and y from 1, with a border that shows nothing.</summary>
    private static bool[,] PixelsOf(VisibleSurface surface)
    {
        bool[,] seen = new bool[surface.Width + 2, surface.Height + 2];
        SurfaceRow row = new();
        for (int y = 1; y <= surface.Height; y++)
        {
            surface.Read(y, row);
            foreach (int column in row.Columns.AsSpan(0, row.Count))
            {
                seen[column + 1, y] = true;
            }
        }

        return seen;
    }

    /// <summary>A pixel that is surely on the disc, or that has the surface on all four sides.</summary>
    private static bool IsSuspect(bool[,] seen, PinholeCamera camera, int x, int y) =>
        (seen[x - 1, y] && seen[x + 1, y] && seen[x, y - 1] && seen[x, y + 1]) || IsOnDisc(camera.RayThrough(x, y));

    private static bool IsOnDisc(Ray ray)
    {
        const double Below = 1_737_400.0 - 5_100.0; // no radius of the model is less, nor are its facets' middles
        double along = -Vector3D.Dot(ray.Origin, ray.Direction) / ray.Direction.LengthSquared;
        return along > 0.0 && (ray.Origin + (along * ray.Direction)).Length < Below;
    }
}
