using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public class PartMeshTests
{
    private const int WholeMoonFaces = (2 * 359 * 720) + (2 * 720); // 2 px/deg

    [Fact]
    public void Build_AllPartsOfTheModelItself_CloseTheSurface()
    {
        LevelMeshBuilders builders = Builders(FunctionGrid.Rough(2));
        ClosedSurface surface = new();
        foreach (SurfacePart part in TileId.All.SelectMany(tile => SurfacePart.Whole(tile).Quarters()))
        {
            surface.Add(Build(builders, part));
        }

        Assert.Equal(0, surface.CountOpenEdges());
        Assert.Equal(0, surface.InwardFaces);
        Assert.Equal(WholeMoonFaces, surface.Faces);
    }

    [Theory]
    [InlineData(0, 15)]
    [InlineData(85, 355)]
    [InlineData(-90, 0)]
    public void Build_PartOfACoarserLevel_IsOpenAtItsWallsFootOnly(int south, int west)
    {
        FunctionGrid grid = FunctionGrid.Rough(8);
        LevelMeshBuilders builders = Builders(grid);
        foreach (SurfacePart part in SurfacePart.Whole(new TileId(south, west), 1).Quarters())
        {
            TileMesh mesh = Build(builders, part);
            ClosedSurface surface = new();
            surface.Add(mesh);
            int edges = mesh.VertexCount - mesh.Layout.VertexCount;

            Assert.Equal(edges, surface.CountOpenEdges());
            Assert.Equal(TileMesh.CountsOf(mesh.Layout), (mesh.VertexCount, mesh.FaceCount));
            Assert.InRange(mesh.Offsets.Max(Math.Abs), 0, TileMesh.OffsetLimit - 1);
            Assert.All(
                Enumerable.Range(mesh.Layout.VertexCount, edges),
                foot => Assert.InRange(mesh.Vertex(foot).PositionBodyFixed.Length, mesh.SkirtFootRadius - 0.01,
                    mesh.SkirtFootRadius + 0.01));
            Assert.True(mesh.SkirtFootRadius < ((IGlobalGrid)grid).RadiusLimits.Min);
        }
    }

    [Fact]
    public void Build_WallsSeenFromBeside_FaceOutwards()
    {
        LevelMeshBuilders builders = Builders(FunctionGrid.OfHeights(4, (_, _) => 0.0));
        TileMesh mesh = Build(builders, SurfacePart.Whole(new TileId(0, 15), 1));
        Vector3D middle = mesh.Origin.PositionBodyFixed;
        for (int face = mesh.Layout.FaceCount; face < mesh.FaceCount; face++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = (Corner(mesh, face, 0), Corner(mesh, face, 1), Corner(mesh, face, 2));
            Assert.True(Vector3D.Dot(Vector3D.Cross(b - a, c - a), a - middle) > 0.0, $"face {face}");
        }
    }

    /// <summary>
    /// What stands at one place at two levels meets no gap: a coarser part reaches half a cell of its own beyond the tile's borders.
    /// </summary>
    [Fact]
    public void For_CoarserPart_CoversTheCellsOfFinerOnes()
    {
        const int Resolution = 64;
        foreach (SurfacePart part in SurfacePart.Whole(new TileId(0, 15), 2).Quarters())
        {
            TileMeshLayout coarse = TileMeshLayout.For(part, Resolution);
            TileMeshLayout fine = TileMeshLayout.For(part with { Level = 0 }, Resolution);

            // Sample i of a level lies at (i + 0.5) / res degrees.
            Assert.True((coarse.FirstLine + 0.5) * 4 <= fine.FirstLine + 0.5);
            Assert.True((coarse.FirstLine + coarse.Lines - 0.5) * 4 >= fine.FirstLine + fine.Lines - 1.5);
            Assert.True((coarse.FirstSample + 0.5) * 4 <= fine.FirstSample + 0.5);
            Assert.True((coarse.FirstSample + coarse.Samples - 0.5) * 4 >= fine.FirstSample + fine.Samples - 1.5);
        }
    }

    [Fact]
    public void Select_MixedLevels_LeavesNoHole()
    {
        FunctionGrid grid = FunctionGrid.Rugged(8);
        LodLevels levels = LodLevels.Open(grid);
        PartSelector selector = new(levels, ElevationSummary.Build(grid), errorPixels: 1.0, cells: 10);
        LevelMeshBuilders builders = new(levels.Level(0), () => levels);
        TerrainTracer tracer = new(grid);
        HashSet<int> met = [];
        List<string> holes = [];
        int cameras = TestLength.Of(12, 24);
        int rays = 0;
        for (int number = 0; number < cameras; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, grid, TestLength.Of(450, 900));
            PartSelection selection = selector.Select(camera, null);
            met.UnionWith(selection.Parts.Select(part => part.Level));
            MeshSoup soup = new([.. selection.Parts.Select(part => Build(builders, part))]);
            bool[] isGround = [.. Enumerable.Range(0, camera.Width * camera.Height).Select(
                pixel => tracer.TryTrace(RayOf(camera, pixel), out _))];
            foreach (int pixel in Enumerable.Range(0, isGround.Length).Where(pixel => IsAmidGround(isGround, camera.Width, pixel)))
            {
                rays++;
                if (!soup.IsHit(RayOf(camera, pixel)))
                {
                    holes.Add($"camera {number} ({kind}), pixel {pixel}");
                }
            }
        }

        Assert.Empty(holes);
        Assert.Superset(new HashSet<int> { 0, 1, 2, 3 }, met);
        Assert.True(rays > 200 * cameras, $"only {rays} rays met the ground");
    }

    private static LevelMeshBuilders Builders(IGlobalGrid grid) => new(grid, () => LodLevels.Open(grid));

    private static TileMesh Build(LevelMeshBuilders builders, SurfacePart part)
    {
        TileMeshLayout layout = TileMeshLayout.For(part, builders.PixelsPerDegree);
        return builders.Of(part.Level).Build(layout, builders.Of(part.Level).ReadRadii(layout));
    }

    private static Vector3D Corner(TileMesh mesh, int face, int corner) => mesh.Vertex(mesh.Faces[(3 * face) + corner]).PositionBodyFixed;

    private static Ray RayOf(PinholeCamera camera, int pixel) => camera.RayThrough((pixel % camera.Width) + 1, (pixel / camera.Width) + 1);

    /// <summary>At the limb a coarser level may be lower by a part of a pixel.</summary>
    private static bool IsAmidGround(bool[] isGround, int width, int pixel)
    {
        int[] around = [0, -1, 1, -width, width, -width - 1, -width + 1, width - 1, width + 1];
        return pixel % width > 0 && pixel % width < width - 1 && pixel >= width && pixel < isGround.Length - width
            && around.All(step => isGround[pixel + step]);
    }
}
