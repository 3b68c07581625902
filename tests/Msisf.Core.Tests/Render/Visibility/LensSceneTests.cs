using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>Every pixel of images through lenses, and of pinholes off the axis, against single rays.</summary>
public sealed class LensSceneTests
{
    /// <summary>m: what rounding may part two computations of a hit by.</summary>
    private const double HitTolerance = 1e-7;

    /// <summary>m: the same, across the facet: a ray that all but grazes it carries 4 ulps of a position far along.</summary>
    private const double AcrossTolerance = 1e-9;

    [Theory]
    [MemberData(nameof(Lenses))]
    public void Run_RuggedModel_ShowsWhatRaysMeet(string lens) =>
        Compare(
            FunctionGrid.Rugged(16), lens, TestLength.Of(16, 60), TestLength.Of(12, 45), Share(lens, RenderScenes.Names), 0.125, -0.375);

    [RequiresTheory(Part.Ldem4)]
    [MemberData(nameof(Lenses))]
    public void Run_RealModel_ShowsWhatRaysMeet(string lens) => Compare(
        MemoryElevationGrid.Ldem4(), lens, TestLength.Of(48, 200), TestLength.Of(36, 150),
        Share(lens, ["far", "oblique-20km", "limb", "inside-crater", "half-sky", "wide-angle", "disc-1e9"]), 0.0, 0.0);

    [Theory]
    [MemberData(nameof(Lenses))]
    public void Read_Row_HasTheBitsOfSinglePixels(string lens)
    {
        FunctionGrid grid = FunctionGrid.Rugged(4);
        RenderScenes.RenderSceneCase scene = RenderScenes.Named("oblique-20km");
        VisibleSurface seen = new VisibilityPass(new SurfaceModel(grid)).Run(
            Camera(scene, lens, grid, 77, 70), 1, CancellationToken.None);
        SurfaceRow row = new();
        int pixels = 0;
        for (int y = 1; y <= seen.Height; y++)
        {
            seen.Read(y, row);
            pixels += row.Count;
            for (int i = 0; i < row.Count; i++)
            {
                Assert.True(seen.TryGet(row.Columns[i] + 1, y, out SurfaceHit hit));
                Assert.Equal(hit.PointBodyFixed, new Vector3D(row.X[i], row.Y[i], row.Z[i]));
                Assert.Equal(hit.RayParameter, row.Parameters[i]);
            }
        }

        Assert.InRange(pixels, seen.Width * seen.Height / 3, seen.Width * seen.Height);
    }

    [Fact]
    public void Run_SeveralThreads_GiveTheSameFrame()
    {
        FunctionGrid grid = FunctionGrid.Rugged(4);
        FrameCamera camera = Camera(RenderScenes.Named("wide-angle"), "barrel", grid, 150, 150);
        VisibilityPass other = new(new SurfaceModel(grid));
        other.Run(
            Camera(RenderScenes.Named("limb"), "fisheye", grid, 159, 150), 2, CancellationToken.None); // leaves what must not show

        VisibleSurface one = new VisibilityPass(new SurfaceModel(grid)).Run(camera, 1, CancellationToken.None);
        VisibleSurface four = other.Run(camera, 4, CancellationToken.None);

        Assert.Equal(one.Counts, four.Counts);
        for (int pixel = 0; pixel < one.Width * one.Height; pixel++)
        {
            (int x, int y) = ((pixel % one.Width) + 1, (pixel / one.Width) + 1);
            Assert.Equal(one.TryGet(x, y, out SurfaceHit hit), four.TryGet(x, y, out SurfaceHit same));
            Assert.Equal(hit, same);
        }
    }

    public static TheoryData<string> Lenses() => [.. LensCases.Names];

    /// <summary>All scenes; every day a third of them, another one for each of three lenses.</summary>
    private static IEnumerable<string> Share(string lens, IEnumerable<string> scenes)
    {
        int first = LensCases.Names.ToList().IndexOf(lens) % 3;
        return scenes.Where((_, number) => TestLength.IsLong || number % 3 == first);
    }

    private static FrameCamera Camera(RenderScenes.RenderSceneCase scene, string lens, IGlobalGrid grid, int width, int height)
    {
        PinholeCamera pinhole = scene.Camera(grid, width, height);
        return LensCases.Of(lens, Math.Tan(0.5 * pinhole.FieldOfView), width, height).At(pinhole.State);
    }

    private static void Compare(
        IGlobalGrid grid, string lens, int width, int height, IEnumerable<string> scenes, double offsetX, double offsetY)
    {
        TerrainTracer tracer = new(grid);
        VisibilityPass pass = new(new SurfaceModel(grid));
        List<string> wrong = [];
        int surface = 0;
        int pixels = 0;
        foreach (RenderScenes.RenderSceneCase scene in scenes.Select(RenderScenes.Named))
        {
            FrameCamera camera = ShiftedCamera.Of(Camera(scene, lens, grid, width, height), offsetX, offsetY);
            VisibleSurface seen = pass.Run(camera, 2, CancellationToken.None);
            for (int pixel = 0; pixel < width * height; pixel++)
            {
                (int x, int y) = ((pixel % width) + 1, (pixel / width) + 1);
                Ray ray = camera.RayThrough(x, y);
                bool isSeen = seen.TryGet(x, y, out SurfaceHit hit);
                bool isHit = tracer.TryTrace(ray, out SurfaceHit expected);
                surface += isSeen ? 1 : 0;
                pixels++;
                if (isSeen != isHit || (isHit && !IsSame(hit, expected, ray.Direction)))
                {
                    wrong.Add($"{scene.Name} ({x}, {y}): seen {hit}, traced {expected}");
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count} pixels: {string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.InRange(surface, pixels / 4, pixels);
    }

    private static bool IsSame(SurfaceHit hit, SurfaceHit expected, Vector3D direction)
    {
        Vector3D apart = hit.PointBodyFixed - expected.PointBodyFixed;
        double sine = Math.Abs(Vector3D.Dot(expected.NormalBodyFixed, direction)) / direction.Length;
        return hit.Facet == expected.Facet
            && (hit.NormalBodyFixed - expected.NormalBodyFixed).Length < Rounding.OfTurns
            && (apart.Length <= HitTolerance || apart.Length * sine <= AcrossTolerance);
    }
}
