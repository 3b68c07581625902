using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Mesh.Bounds;

public sealed class BlockBoundsTableTests
{
    [Theory]
    [InlineData(2)]
    [InlineData(16)]
    public void Of_EachBlock_HoldsItsFacets(int pixelsPerDegree)
    {
        SurfaceModel surface = new(FunctionGrid.Hilly(pixelsPerDegree));
        BlockVertices vertices = new();
        for (int row = 0; row < surface.Bounds.Rows; row += 3)
        {
            for (int column = 0; column < surface.Bounds.Columns; column += 5)
            {
                BlockBounds bounds = surface.Bounds.Of(new CellBlock(row, column));
                vertices.Load(surface, new CellBlock(row, column), default);
                double steepest = 0.0;
                for (int i = 0; i + 1 < vertices.Lines; i++)
                {
                    for (int j = 0; j + 1 < vertices.Samples; j++)
                    {
                        Vector3D northWest = vertices[i, j];
                        Vector3D southEast = vertices[i + 1, j + 1];
                        Assert.InRange(northWest.Length, bounds.Min - Tolerances.VertexLattice, bounds.Max + Tolerances.VertexLattice);
                        steepest = Math.Max(steepest, Slope(northWest, vertices[i + 1, j], southEast));
                        steepest = Math.Max(steepest, Slope(northWest, southEast, vertices[i, j + 1]));
                    }
                }

                Assert.InRange(steepest, 0.0, bounds.MaxSlope);
                Assert.InRange(bounds.MaxSlope, 0.0, (2.5 * steepest) + 0.01); // a bound that says nothing would pass too
            }
        }
    }

    /// <summary>Tangent of the angle between a facet's normal and the zenith of its middle; 0 for a fan's facet without area.</summary>
    private static double Slope(Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        return normal.Length > 0.0 ? Math.Tan(Vector3D.AngleBetween(normal, a + b + c)) : 0.0;
    }

    [Fact]
    public void Of_SameBlockFromManyThreads_IsOneValue()
    {
        SurfaceModel surface = new(FunctionGrid.Hilly(4));
        BlockBounds[] found = new BlockBounds[64];
        Parallel.For(0, found.Length, i => found[i] = surface.Bounds.Of(new CellBlock(3, i % 4)));
        for (int i = 4; i < found.Length; i++)
        {
            Assert.Equal(found[i - 4], found[i]);
        }
    }
}
