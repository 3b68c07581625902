using Msisf.Core.Blocks;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Blocks;

/// <summary>The blocks of a scene against all facets of its surface, by brute force.</summary>
public sealed class SceneBlocksTests
{
    private const int Size = 64;

    public static TheoryData<string> Scenes => ["polar", "five", "five at 0-102", "gaps", "piece", "map", "map at 1", "map-aside"];

    /// <summary>
    /// With the facets of the blocks alone each ray of the image meets the same facet, and that is lit or dark as with all.
    /// </summary>
    [Theory]
    [MemberData(nameof(Scenes))]
    public void Select_AnyRayOfTheImage_MeetsTheSameFacetWithTheSameLight(string name)
    {
        ITerrain terrain = TerrainOf(name);
        AllFacets all = terrain is NestedTerrain ? NestedScenes.FacetsOf(name) : new AllFacets(terrain);
        SceneBlocks blocks = new(terrain);
        Random random = new(20120222);
        List<string> wrong = [];
        int hits = 0;
        int dark = 0;
        int left = 0;
        foreach ((string view, PinholeCamera camera, Vector3D sun) in ViewsOf(terrain))
        {
            PixelRows? rows = view == "middle" ? new PixelRows(Size / 2, Size) : null;
            IReadOnlyList<SceneBlock> needed = blocks.Select(camera, sun, rows, threads: 2, CancellationToken.None);
            AllFacets there = FacetsOf(blocks, needed, all);
            AllFacets unlit = FacetsOf(blocks, blocks.Select(camera, null, rows, threads: 2, CancellationToken.None), all);
            left += all.Facets.Count - there.Facets.Count;
            for (int number = 0; number < TestLength.Of(6, 150); number++)
            {
                // Up to a pixel beside the image, as antialiasing's rays.
                double y = rows is null ? -0.4 + ((Size + 1.8) * random.NextDouble()) : (Size / 2) + (Size / 2 * random.NextDouble());
                Ray ray = camera.RayThrough(-0.4 + ((Size + 1.8) * random.NextDouble()), y);
                (FacetId Facet, Vector3D Point, double T)? expected = all.FirstHit(ray.Origin, ray.Direction);
                bool isSame = there.FirstHit(ray.Origin, ray.Direction) == expected
                    && unlit.FirstHit(ray.Origin, ray.Direction) == expected;
                if (expected is (FacetId facet, Vector3D point, _))
                {
                    bool isShadowed = all.IsShadowed(facet, point, sun);
                    isSame &= there.IsShadowed(facet, point, sun) == isShadowed || FacesAway(terrain, facet, sun);
                    hits++;
                    dark += isShadowed ? 1 : 0;
                }

                if (!isSame)
                {
                    wrong.Add($"{view} {number}: {expected}");
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count}: {string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.True(hits > 5 && dark > 0 && dark < hits, $"{hits} hits, {dark} of them dark");
        Assert.True(left > all.Facets.Count / 5, $"only {left} of {all.Facets.Count} facets were left out in all views together");
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void MeshesOf_BlocksOfTheWholeMoon_AreItsFacetsEachOnce(string name)
    {
        ITerrain terrain = TerrainOf(name);
        AllFacets all = terrain is NestedTerrain ? NestedScenes.FacetsOf(name) : new AllFacets(terrain);
        SceneBlocks blocks = new(terrain);
        HashSet<SceneBlock> seen = [];
        foreach (Vector3D axis in (Vector3D[])[Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ])
        {
            foreach (double side in (double[])[-1e7, 1e7])
            {
                PinholeCamera camera = new(
                    side * axis, CameraCases.Attitude(-Math.Sign(side) * axis, new Vector3D(axis.Y, axis.Z, axis.X)), 0.5, 64, 64);
                seen.UnionWith(blocks.Select(camera, null, null, threads: 2, CancellationToken.None));
            }
        }

        List<(Vector3D A, Vector3D B, Vector3D C)> facets = [.. seen.Order().SelectMany(blocks.MeshesOf).SelectMany(TrianglesOf)];

        Assert.Equal(
            all.Facets.GroupBy(facet => facet.Facet.Part).Select(part => (part.Key, part.Count())).Order(),
            seen.GroupBy(block => block.Part).Select(
                part => (part.Key, part.Sum(block => blocks.MeshesOf(block).Sum(mesh => mesh.FaceCount)))).Order());
        Assert.Equal(all.Facets.Count, facets.Count);
        Assert.Equal(all.Facets.Select(facet => (facet.A, facet.B, facet.C)).ToHashSet(), facets.ToHashSet());
        Assert.InRange(blocks.CountFaces(seen), facets.Count, 2 * facets.Count);
        Assert.Equal(terrain is NestedTerrain, blocks.IsClosed);
    }

    [Fact]
    public void MeshesOf_CellsTooHighForThePrecision_IsBadInput()
    {
        // Steps of 2^-11 m; 2^24 of them are 8 km.
        PolarFunctionGrid cliff = new(new PolarStereographic(true, 1.0, 20.0, 20.0), 40, 40, (line, _) => line < 20 ? 0.0 : 18_000.0);
        BadInputException exception = Assert.Throws<BadInputException>(() => new SceneBlocks(cliff).MeshesOf(new SceneBlock(0, 0, 0)));
        Assert.Contains("--renderer native", exception.Message, StringComparison.Ordinal);
    }

    private static ITerrain TerrainOf(string name) => name switch
    {
        "map" => PolarFunctionGrid.Rugged(true, 3000.0, 90, 44.5, 44.5),
        "map at 1" => MapLevels.Open(PolarFunctionGrid.Rugged(true, 1500.0, 180, 89.5, 89.5)).Grid(1),
        "map-aside" => PolarFunctionGrid.Rugged(false, 5.0, 150, 90.0, 21000.5),
        _ => NestedScenes.Named(name),
    };

    private static bool FacesAway(ITerrain terrain, FacetId facet, Vector3D sun)
    {
        (Vector3D a, Vector3D b, Vector3D c) = SurfaceModel.Of(terrain).CornersOf(facet);
        return Vector3D.Dot(Vector3D.Cross(b - a, c - a), sun - a) <= 0.0;
    }

    private static AllFacets FacetsOf(SceneBlocks blocks, IReadOnlyList<SceneBlock> needed, AllFacets all)
    {
        HashSet<(Vector3D A, Vector3D B, Vector3D C)> triangles = [.. needed.SelectMany(blocks.MeshesOf).SelectMany(TrianglesOf)];
        AllFacets there = all.Where(facet => triangles.Contains((facet.A, facet.B, facet.C)));
        Assert.Equal(triangles.Count, there.Facets.Count);
        return there;
    }

    private static IEnumerable<(Vector3D A, Vector3D B, Vector3D C)> TrianglesOf(BlockMesh mesh)
    {
        Vector3D Vertex(int number) => Math.ScaleB(1.0, -mesh.LatticeExponent) * new Vector3D(
            mesh.Origin.X + mesh.Offsets[3 * number],
            mesh.Origin.Y + mesh.Offsets[(3 * number) + 1],
            mesh.Origin.Z + mesh.Offsets[(3 * number) + 2]);

        for (int face = 0; face < mesh.Faces.Length; face += 3)
        {
            yield return (Vertex(mesh.Faces[face]), Vertex(mesh.Faces[face + 1]), Vertex(mesh.Faces[face + 2]));
        }
    }

    /// <summary>Over the border of the finest model and its middle, from near and far, with low Suns.</summary>
    private static List<(string Name, PinholeCamera Camera, Vector3D Sun)> ViewsOf(ITerrain terrain)
    {
        ITerrainGrid finest = terrain is NestedTerrain nested ? nested.Models[^1] : (ITerrainGrid)terrain;
        GridWindow window = finest.Window;
        double scale = finest.Projection.Resolution.MetresPerPixel;
        Vector3D border = finest.Projection.DirectionOf(window.FirstLine + 2, 0.5 * (window.FirstSample + window.EndSample));
        Vector3D middle = finest.Projection.DirectionOf(
            0.5 * (window.FirstLine + window.EndLine), 0.5 * (window.FirstSample + window.EndSample));
        return
        [
            At("border", border, 40.0 * scale, 0.0, 0.0, 60.0, 15.0, 100.0),
            At("middle", middle, 80.0 * scale, 10.0, 60.0, 70.0, 8.0, 200.0),
            At("low", middle, 6.0 * scale, 80.0, 300.0, 70.0, 1.5, 250.0),
            At("whole", border, 4e6, 0.0, 0.0, 40.0, 10.0, 300.0),
        ];

        (string, PinholeCamera, Vector3D) At(
            string name, Vector3D place, double height, double tilt, double azimuth, double fov, double elevation, double sunAzimuth)
        {
            SelenographicPoint point = SelenographicPoint.Below(place);
            RenderScenes.RenderSceneCase scene = new(
                name, double.RadiansToDegrees(point.Latitude), double.RadiansToDegrees(point.Longitude), height, tilt, azimuth, fov,
                elevation, sunAzimuth);
            return (name, scene.Camera(terrain, Size, Size), scene.Sun);
        }
    }
}
