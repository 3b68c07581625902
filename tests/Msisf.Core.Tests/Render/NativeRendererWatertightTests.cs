using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Core.Tests.Render;

/// <summary>
/// Small images from random cameras of all kinds: no ray that must meet the ground passes through it, and none that can't meet it does.
/// </summary>
public sealed class NativeRendererWatertightTests(ITestOutputHelper output)
{
    /// <summary>1: chords of facets lie a little lower than their vertices, 6e-5 of the radius at 1 px/deg.</summary>
    private const double SafePart = 0.999;

    private const int MinPixels = 16 * 16;
    private const int MaxPixels = 32 * 32;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    [RequiresFact(Part.Ldem4)]
    public void Render_RealModel_HasNoHole() => AssertNoHole(MemoryElevationGrid.Ldem4(), TestLength.Of(200, 10_000));

    [Fact]
    public void Render_RuggedTerrain_HasNoHole() => AssertNoHole(RuggedTerrain.InMemory(2), TestLength.Of(400, 10_000));

    private void AssertNoHole(MemoryElevationGrid grid, int views)
    {
        (double lowest, double highest) = grid.RadiusLimits; // as tight as can be
        NativeRenderer renderer = new(grid);
        List<string> wrong = [];
        long inside = 0;
        long outside = 0;
        Random sizes = new(20120222);
        for (int number = 0; number < views; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, grid, sizes.Next(MinPixels, MaxPixels + 1));
            SceneLight lamp = new(camera.PositionBodyFixed, IsSun: false);
            using NativeFrame frame = renderer.Render(camera, lamp, Options, threads: 1);
            for (int pixel = 0; pixel < camera.Width * camera.Height; pixel++)
            {
                (int x, int y) = ((pixel % camera.Width) + 1, (pixel / camera.Width) + 1);
                double approach = RayGeometry.NearestApproach(camera.RayThrough(x, y));
                bool mustHit = approach < SafePart * lowest;
                bool canHit = approach <= highest / SafePart;
                bool isHit = frame.TryGet(x, y, out _, out _);
                inside += mustHit ? 1 : 0;
                outside += canHit ? 0 : 1;
                if ((mustHit && !isHit) || (isHit && !canHit))
                {
                    wrong.Add(
                        $"view {number} ({kind}), pixel ({x}, {y}) of {camera.Width} x {camera.Height}: "
                            + $"surface {isHit}, {approach} m from the centre");
                }
            }
        }

        output.WriteLine($"{grid.ProductId}: {views} views, {inside} pixels inside the disc, {outside} beside it, {wrong.Count} wrong");
        Assert.True(
            wrong.Count == 0,
            $"{wrong.Count} of {inside + outside}:{Environment.NewLine}{string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.True(inside > 100 * views && outside > 50 * views, $"{inside} inside, {outside} outside say little");
    }
}
