using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

public sealed class BlockCullerTests
{
    /// <summary>
    /// Every facet of every block that is left out: it is outside the image, turns away, or lies behind the maximum sphere within the Moon.
    /// </summary>
    [Fact]
    public void Find_BlocksLeftOut_AreOutOfSight()
    {
        MemoryElevationGrid grid = MemoryElevationGrid.Of(FunctionGrid.Rugged(4));
        SurfaceModel surface = new(grid);
        BlockCuller culler = new(surface);
        LatticeVertices vertices = new(grid);
        FacetId[] facets = [.. FacetsOf(vertices)];
        (Vector3D Normal, Vector3D Middle)[] places = [.. facets.Select(facet => PlaceOf(vertices, facet))];
        int leftOut = 0;
        List<string> wrong = [];
        for (int number = 0; number < TestLength.Of(1, 2) * CameraCases.Kinds; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, grid, 1024);
            Vector3D position = camera.PositionBodyFixed;
            HashSet<CellBlock> found = [.. culler.Find(
                new ImageView(camera).Frustum(), threads: 2, CancellationToken.None).Select(block => block.Block)];
            for (int i = 0; i < facets.Length; i++)
            {
                Vector3D toMiddle = places[i].Middle - position;
                if (Vector3D.Dot(places[i].Normal, toMiddle) < 0.0
                    && !found.Contains(new CellBlock((facets[i].Line + 1) / CellBlock.Size, facets[i].Sample / CellBlock.Size)))
                {
                    leftOut++;
                    if (IsInImage(camera, toMiddle) && !IsBehindSphere(position, places[i].Middle, grid.RadiusLimits.Min))
                    {
                        wrong.Add($"view {number} ({kind}), {facets[i]}");
                    }
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count} facets: {string.Join(", ", wrong.Take(5))}");
        Assert.InRange(leftOut, 250_000, int.MaxValue);
    }

    private static IEnumerable<FacetId> FacetsOf(LatticeVertices vertices) =>
        from line in Enumerable.Range(-1, vertices.Lines + 1)
        from sample in Enumerable.Range(0, vertices.Samples)
        from half in new[] { FacetHalf.SouthWest, FacetHalf.NorthEast }
        where line >= 0 || half == FacetHalf.SouthWest
        where line < vertices.Lines - 1 || half == FacetHalf.NorthEast
        select new FacetId(line, sample, half);

    private static (Vector3D Normal, Vector3D Middle) PlaceOf(LatticeVertices vertices, FacetId facet)
    {
        (Vector3D a, Vector3D b, Vector3D c) = vertices.CornersOf(facet);
        return (vertices.NormalOf(facet), (a + b + c) / 3.0);
    }

    private static bool IsInImage(PinholeCamera camera, Vector3D direction) =>
        camera.TryProject(direction, out RenderingPoint point)
        && point.X >= 0.5 && point.X <= camera.Width + 0.5 && point.Y >= 0.5 && point.Y <= camera.Height + 0.5;

    private static bool IsBehindSphere(Vector3D from, Vector3D to, double radius)
    {
        Vector3D along = to - from;
        double part = Math.Clamp(-Vector3D.Dot(from, along) / along.LengthSquared, 0.0, 1.0);
        return (from + (part * along)).Length < radius;
    }
}
