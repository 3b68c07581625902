using Msisf.Adapters.Tiles;
using Msisf.Core.Numerics;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Tiles;

/// <summary>What POV-Ray itself makes of a pattern, asked by its own trace().</summary>
public sealed class PatternPovRayTests : IDisposable
{
    // km: POV-Ray keeps a triangle's normal and distance as 32-bit floats too, so a hit is off by up to 2^-24 of the
    // distance from the tile's origin (110 km); 2.0e-6 km were measured here, 9.7e-5 km with absolute coordinates.
    private const double PlaneError = 5e-6;
    private const double AbsoluteError = 2e-4;

    // 4 px/deg, slopes of up to 15 degrees everywhere, also at the poles.
    private static readonly FunctionGrid Hills = new(4, (line, sample) =>
        1_737_400.0 + (4000.0 * Math.Sin(0.11 * line)) + (3000.0 * Math.Sin(Math.PI * line / 720.0) * Math.Cos(Math.PI * sample / 12.0)));

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    // Rays from 10 m to 4e5 km away (the Earth), on slopes of 15 degrees: with lattice steps as the mesh's own units nothing beyond 78 km
    // is hit. A ray at the very corner may pass between the edges of triangles, so it aims some parts of the edges beside it.
    [RequiresTheory(Part.PovRay)]
    [InlineData(PatternFormat.Mesh2, 0.01, 1e-3, PlaneError)]
    [InlineData(PatternFormat.Mesh2, 100.0, 1e-3, PlaneError)]
    [InlineData(PatternFormat.Mesh2, 400000.0, 1e-3, PlaneError)]
    [InlineData(PatternFormat.Mesh, 100.0, 0.1, AbsoluteError)]
    public void Trace_BesideVertices_HitsThem(PatternFormat format, double distanceKm, double inside, double toleranceKm)
    {
        TileId[] tiles = [new(0, 0), new(40, 130), new(-35, 355), new(85, 40), new(-90, 200)];
        TileMeshBuilder builder = new(Hills);
        PatternSet patterns = new PatternRepository(_folder["p"]).EnsurePatterns(
            tiles, Hills, new PatternOptions(0.0, format), maxParallelism: 2);
        PovRayTrace trace = new(_folder.Path);
        trace.Declare("All", patterns.Paths);
        List<Vector3D> expectedKm = [];
        foreach (TileId tile in tiles)
        {
            TileMeshLayout layout = TileMeshLayout.For(tile, 4);
            TileMesh mesh = builder.Build(layout, builder.ReadRadii(layout));
            for (int face = 0; face < layout.FaceCount; face += 97)
            {
                Vector3D targetKm = BesideFirstCorner(mesh, face, inside);
                Vector3D upward = targetKm.Normalized();
                Vector3D startKm = targetKm + (distanceKm * upward);
                trace.Add("All", startKm, -upward);
                expectedKm.Add(targetKm);
            }
        }

        Vector3D[] hitsKm = [.. trace.Run().Select(hit => hit.PointKm)];

        Assert.Equal(expectedKm.Count, hitsKm.Length);
        Assert.InRange(expectedKm.Zip(hitsKm, (expected, hit) => (expected - hit).Length).Max(), 0.0, toleranceKm);
    }

    private static Vector3D BesideFirstCorner(TileMesh mesh, int face, double inside)
    {
        Vector3D a = mesh.Vertex(mesh.Faces[3 * face]).PositionBodyFixed;
        Vector3D b = mesh.Vertex(mesh.Faces[(3 * face) + 1]).PositionBodyFixed;
        Vector3D c = mesh.Vertex(mesh.Faces[(3 * face) + 2]).PositionBodyFixed;
        return (a + (inside * (b - a)) + (inside * (c - a))) / 1000.0;
    }
}
