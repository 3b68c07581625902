using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public sealed class PlaneGeometryTests
{
    /// <summary>tests/reference/polar_map.py (mpmath, by latitude and longitude): direction, k, position in steps of 2^-k m.</summary>
    [Theory]
    [InlineData(
        true, 20.0, 15199.5, 15199.5, 0, 0, 1738123.5,
        0.17233048751679410889, -0.17233048751679410889, -0.9698476200643316213, 7, 38340054L, -38340054L, -215771512L)]
    [InlineData(
        true, 20.0, 15199.5, 15199.5, 15199, 15200, 1736000,
        5.7557269482182330128e-6, 5.7557269482182330128e-6, -0.9999999999668716073, 7, 1279L, 1279L, -222208000L)]
    [InlineData(
        true, 20.0, 15199.5, 15199.5, 30399, 7, 1737400.5,
        -0.17233168377644353914, -0.17225231789030023806, -0.9698612940767328195, 7, -38324372L, -38306722L, -215684800L)]
    [InlineData(
        true, 5.0, 15167.5, 15167.5, 4711, 30335, 1741029.5,
        0.030071247800661355817, 0.043619342133269364927, -0.99859555028428401842, 9, 26805724L, 38882591L, -890155168L)]
    [InlineData(
        false, 5.0, 15167.5, 15167.5, 4711, 30335, 1741029.5,
        -0.030071247800661355817, 0.043619342133269364927, 0.99859555028428401842, 9, -26805724L, 38882591L, 890155168L)]
    [InlineData(
        false, 100.0, 14399.5, 14399.5, 28799, 28799, 1732111,
        0.61691546795296312536, 0.61691546795296312536, 0.48870298832803657628, 7, 136776457L, 136776457L, 108350441L)]
    [InlineData(
        true, 1.0, -3000.25, 12000.75, 77, 1, 1737399.875,
        -0.0017711585637532108798, -0.0069066406614339401268, -0.99997458033297819976, 11, -6302127L, -24575174L, -3558104496L)]
    [InlineData(
        false, 80.0, 3799.5, 3799.5, 3799, 3799, 1737400,
        -0.000023022907787152592574, -0.000023022907787152592574, 0.99999999946994571688, 7, -5120L, -5120L, 222387200L)]
    public void Vertex_AnyPlace_IsTheLatticePointOfTheReference(
        bool isSouth, double scale, double lineOffset, double sampleOffset, int line, int sample, double radius,
        double dx, double dy, double dz, int k, long x, long y, long z)
    {
        PolarStereographic map = new(isSouth, scale, lineOffset, sampleOffset);
        PlaneGeometry geometry = new(map, new FacetMesh(new PolarFunctionGrid(map, 2, 30400, (_, _) => 0.0)));
        Assert.InRange((new Vector3D(dx, dy, dz) - map.DirectionOf(line, sample)).Length, 0.0, 4e-16); // 7e-10 m
        Assert.Equal(Math.Pow(2.0, k), geometry.StepsPerMetre);
        Assert.Equal(new Vector3D(x, y, z) / geometry.StepsPerMetre, geometry.Vertex(line, sample, radius));
    }

    /// <summary>A map about another axis is the polar one, turned: so are its vertices, one by one and by lines, and its borders.</summary>
    [Theory]
    [InlineData(1, false)]
    [InlineData(2, false)]
    [InlineData(1, true)]
    [InlineData(2, true)]
    public void Vertex_MapAboutAnotherAxis_IsThePolarOneTurned(int turn, bool isSouth)
    {
        PolarStereographic polar = new(isSouth, 64.0, -310.0, 77.0);
        PolarStereographic turned = polar with { Turn = turn };
        PlaneGeometry geometry = new(turned, new FacetMesh(new PolarFunctionGrid(turned, 2, 64, (_, _) => 0.0)));
        PlaneGeometry expected = new(polar, new FacetMesh(new PolarFunctionGrid(polar, 2, 64, (_, _) => 0.0)));
        double[] radii = [.. Enumerable.Range(0, 16).Select(i => 1.737e6 + (13.7 * i))];
        (double[] x, double[] y, double[] z) = (new double[16], new double[16], new double[16]);
        Vector3D origin = new(1e6, -5e5, 3e4);
        geometry.PlaceLine(1, 8, radii, origin, x, y, z);
        for (int i = 0; i < radii.Length; i++)
        {
            Vector3D vertex = geometry.Vertex(1, 8 + i, radii[i]);
            Vector3D upright = expected.Vertex(1, 8 + i, radii[i]);
            Assert.Equal(turn == 1 ? new Vector3D(upright.Z, upright.X, upright.Y) : new Vector3D(upright.Y, upright.Z, upright.X), vertex);
            Assert.Equal(vertex - origin, new Vector3D(x[i], y[i], z[i]));
            (double line, double sample) = turned.PixelOf(vertex);
            Assert.InRange(line, 1.0 - 1e-3, 1.0 + 1e-3); // px: vertices are rounded to the lattice
            Assert.InRange(sample, 8 + i - 1e-3, 8 + i + 1e-3); // px: the same
        }

        CellRange cells = new(0, 1, 8, 24);
        SphericalCap cap = geometry.Nodes.CapOf(cells);
        (Vector3D north, Vector3D south) = geometry.LineBorders(cells);
        Assert.True(geometry.TryGetColumnBorders(cells, out Vector3D west, out Vector3D east));
        Vector3D middle = turned.DirectionOf(0.5, 16.0);
        Assert.True(Vector3D.Dot(middle, cap.Centre) > 1.0 - Rounding.OfPlaces);
        Assert.All([north, south, west, east], border => Assert.True(Vector3D.Dot(border, middle) > 0.0));
        Assert.True(Vector3D.Dot(west, turned.DirectionOf(0.5, 7.0)) < 0.0 && Vector3D.Dot(east, turned.DirectionOf(0.5, 25.0)) < 0.0);
        Assert.True(Vector3D.Dot(north, turned.DirectionOf(-1.0, 16.0)) < 0.0 && Vector3D.Dot(south, turned.DirectionOf(2.0, 16.0)) < 0.0);
    }

    [Theory]
    [InlineData(20.0, 7)]
    [InlineData(16.0, 7)]
    [InlineData(10.0, 8)]
    [InlineData(5.0, 9)]
    [InlineData(2.0, 10)]
    [InlineData(1.0, 11)]
    [InlineData(0.5, 12)]
    [InlineData(1000.0, 7)]
    public void LatticeOf_CellWidth_IsAtMostA2048thOfIt(double cell, int k) => Assert.Equal(k, PlaneGeometry.LatticeOf(cell));

    [Fact]
    public void Load_AnyBlock_GivesTheVertices()
    {
        PolarFunctionGrid grid = PolarFunctionGrid.Rugged(true, 5.0, 75, 30.5, -4000.25);
        SurfaceModel surface = new(grid);
        BlockVertices vertices = new();
        Vector3D origin = new(0.5, -3.25, 17.0);
        double[] radius = new double[1];
        int cells = 0;
        for (int row = 0; row < CellBlock.RowsOf(surface.Parts[0].Mesh); row++)
        {
            for (int column = 0; column < CellBlock.ColumnsOf(surface.Parts[0].Mesh); column++)
            {
                vertices.Load(surface, new CellBlock(row, column), origin);
                cells += vertices.Cells.Lines * vertices.Cells.Samples;
                for (int line = 0; line < vertices.Lines; line++)
                {
                    for (int sample = 0; sample < vertices.Samples; sample++)
                    {
                        (int atLine, int atSample) = (vertices.Cells.FirstLine + line, vertices.Cells.FirstSample + sample);
                        grid.ReadRadii(atLine, atSample, radius);
                        Assert.Equal(surface.Parts[0].Vertex(atLine, atSample, radius[0]) - origin, vertices[line, sample]);
                    }
                }
            }
        }

        Assert.Equal(74 * 74, cells);
    }

    /// <summary>Caps, boxes and slopes of nodes of all levels, and the planes around their cells.</summary>
    [Theory]
    [InlineData(true, 3000.0, 140, 69.5, 69.5)]
    [InlineData(false, 12000.0, 140, 69.5, 100.0)]
    [InlineData(false, 12000.0, 70, 0.0, 139.0)]
    [InlineData(true, 20.0, 100, -11000.0, 9000.5)]
    [InlineData(false, 5.0, 100, 60.0, 20000.0)]
    public void Bounds_OfEachNode_HoldItsFacets(bool isSouth, double scale, int side, double poleLine, double poleSample)
    {
        PolarFunctionGrid grid = PolarFunctionGrid.Rugged(isSouth, scale, side, poleLine, poleSample);
        SurfaceModel surface = new(grid);
        BoundsLayout layout = surface.Parts[0].Bounds.Layout;
        for (int level = 0; level < layout.Levels; level++)
        {
            int step = level == 0 ? 5 : 1;
            for (int row = 0; row < layout.Rows(level); row += step)
            {
                for (int column = 0; column < layout.Columns(level); column += step)
                {
                    CheckNode(surface, layout.Cells(level, row, column), level, row, column);
                }
            }
        }
    }

    private static void CheckNode(SurfaceModel surface, CellRange cells, int level, int row, int column)
    {
        NodeBounds bounds = surface.Parts[0].Bounds.Of(level, row, column);
        SphericalCap cap = surface.Parts[0].Bounds.CapOf(level, row, column);
        OrientedBox box = surface.Parts[0].Bounds.BoxOf(level, row, column, bounds.Min, bounds.Max).Box;
        Assert.True(surface.Parts[0].Geometry.TryGetColumnBorders(cells, out Vector3D west, out Vector3D east));
        (Vector3D north, Vector3D south) = surface.Parts[0].Geometry.LineBorders(cells);
        Assert.All(new[] { west, east, north, south }, normal => Assert.InRange(normal.Length, 0.3, 1.5));
        double steepest = 0.0;
        for (int line = cells.FirstLine; line < cells.EndLine; line++)
        {
            for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
            {
                CellCorners corners = surface.Parts[0].Corners(line, sample);
                steepest = Math.Max(steepest, Math.Max(Slope(corners, FacetHalf.SouthWest), Slope(corners, FacetHalf.NorthEast)));
                foreach (Vector3D corner in new[] { corners.NorthWest, corners.NorthEast, corners.SouthWest, corners.SouthEast })
                {
                    Assert.InRange(corner.Length, bounds.Min - Tolerances.VertexLattice, bounds.Max + Tolerances.VertexLattice);
                    Assert.True(Vector3D.Dot(corner.Normalized(), cap.Centre) >= cap.CosRadius - Rounding.OfUnits);
                    Vector3D inBox = corner - box.Centre;
                    Assert.True(Math.Abs(Vector3D.Dot(inBox, box.HalfX)) <= box.HalfX.LengthSquared * (1.0 + Rounding.OfChains));
                    Assert.True(Math.Abs(Vector3D.Dot(inBox, box.HalfY)) <= box.HalfY.LengthSquared * (1.0 + Rounding.OfChains));
                    Assert.True(Math.Abs(Vector3D.Dot(inBox, box.HalfZ)) <= box.HalfZ.LengthSquared * (1.0 + Rounding.OfChains));
                    foreach (Vector3D normal in new[] { west, east, north, south })
                    {
                        Assert.True(Vector3D.Dot(normal, corner) >= -Tolerances.VertexLattice);
                    }
                }
            }
        }

        Assert.InRange(steepest, 0.0, bounds.MaxSlope);

        // Bounds that say nothing would pass too.
        Assert.InRange(bounds.MaxSlope, 0.0, (2.5 * steepest) + 0.01);
        double scale = ((PolarStereographic)surface.Parts[0].Grid.Projection).MetresPerPixel;
        double angle = Math.Max(cells.Lines, cells.Samples) * scale / MoonConstants.ReferenceRadius;
        Assert.InRange(cap.SinRadius, 0.0, (0.75 * angle) + 1e-6);
        Assert.InRange(Math.Max(box.HalfY.Length, box.HalfZ.Length), 0.0, (0.75 * angle * MoonConstants.ReferenceRadius) + 1.0);
    }

    private static double Slope(CellCorners corners, FacetHalf half)
    {
        (Vector3D a, Vector3D b, Vector3D c) = corners.Facet(half);
        return Math.Tan(Vector3D.AngleBetween(Vector3D.Cross(b - a, c - a), a + b + c));
    }
}
