using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Terrain;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public sealed class BoundsTreeTests
{
    /// <summary>
    /// Cell blocks and groups of them, which are unions; and the patches, on which rays walk, near the poles and the prime meridian.
    /// </summary>
    [Theory]
    [InlineData(2, SquareLayout.CellBlockLevel)]
    [InlineData(16, SquareLayout.CellBlockLevel)]
    [InlineData(16, SquareLayout.GroupLevel)]
    [InlineData(1, SquareLayout.PatchLevel)]
    public void Of_EachNode_HoldsItsFacets(int pixelsPerDegree, int level)
    {
        SurfaceModel surface = new(FunctionGrid.Hilly(pixelsPerDegree));
        BoundsLayout layout = surface.Parts[0].Bounds.Layout;
        for (int row = 0; row < layout.Rows(level); row += 3)
        {
            for (int column = 0; column < layout.Columns(level); column += 5)
            {
                NodeBounds bounds = surface.Parts[0].Bounds.Of(level, row, column);
                CellRange cells = layout.Cells(level, row, column);
                double steepest = 0.0;
                for (int line = cells.FirstLine; line < cells.EndLine; line++)
                {
                    for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
                    {
                        CellCorners corners = surface.Parts[0].Corners(line, sample);
                        Assert.InRange(
                            corners.NorthWest.Length, bounds.Min - Tolerances.VertexLattice, bounds.Max + Tolerances.VertexLattice);
                        Assert.InRange(
                            corners.SouthEast.Length, bounds.Min - Tolerances.VertexLattice, bounds.Max + Tolerances.VertexLattice);
                        steepest = Math.Max(steepest, Slope(corners.Facet(FacetHalf.SouthWest)));
                        steepest = Math.Max(steepest, Slope(corners.Facet(FacetHalf.NorthEast)));
                    }
                }

                Assert.InRange(steepest, 0.0, bounds.MaxSlope);
                Assert.InRange(bounds.MaxSlope, 0.0, (2.5 * steepest) + 0.01); // a bound that says nothing would pass too
            }
        }
    }

    /// <summary>Groups of 4 x 4 blocks, 129 x 129 vertices; at the prime meridian the vertices go on with sample 0.</summary>
    [Theory]
    [InlineData(40, 12)]
    [InlineData(40, 179)]
    public void Of_GroupOfBlocks_FetchesExactlyWhatItReads(int row, int column)
    {
        FetchedGrid grid = new(FunctionGrid.Hilly(64));
        BoundsTree tree = new GridPatch(grid).Bounds;

        tree.Of(SquareLayout.GroupLevel, row, column);

        Assert.Equal((129 * 129, 0, 0), (grid.Read, grid.ReadUnfetched, grid.FetchedInVain));
    }

    /// <summary>Tangent of the angle between a facet's normal and the zenith of its middle; 0 for a fan's facet without area.</summary>
    private static double Slope((Vector3D A, Vector3D B, Vector3D C) facet)
    {
        (Vector3D a, Vector3D b, Vector3D c) = facet;
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        return normal.Length > 0.0 ? Math.Tan(Vector3D.AngleBetween(normal, a + b + c)) : 0.0;
    }

    [Fact]
    public void Of_SameNodeFromManyThreads_IsOneValue()
    {
        SurfaceModel surface = new(FunctionGrid.Hilly(4));
        NodeBounds[] found = new NodeBounds[64];
        System.Threading.Tasks.Parallel.For(
            0, found.Length, i => found[i] = surface.Parts[0].Bounds.Of(SquareLayout.CellBlockLevel, 3, i % 4));
        for (int i = 4; i < found.Length; i++)
        {
            Assert.Equal(found[i - 4], found[i]);
        }
    }

    [Fact]
    public void TryGetKnown_GroupOfBlocks_IsKnownWhenItsLastBlockIs()
    {
        BoundsTree tree = new GridPatch(FunctionGrid.Hilly(4)).Bounds;
        NodeBounds union = NodeBounds.Empty;
        for (int block = 0; block < SquareLayout.GroupBlocks; block++)
        {
            Assert.False(tree.TryGetKnown(SquareLayout.GroupLevel, 1, 2, out _));
            union = NodeBounds.Union(union, tree.Of(SquareLayout.CellBlockLevel, 4 + (block / 4), 8 + (block % 4)));
        }

        Assert.True(tree.TryGetKnown(SquareLayout.GroupLevel, 1, 2, out NodeBounds known));
        Assert.Equal(union, known);
    }
}
