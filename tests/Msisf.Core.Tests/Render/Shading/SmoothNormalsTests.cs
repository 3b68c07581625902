using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shading;

public sealed class SmoothNormalsTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    /// <summary>rad: rounding of weights and normals.</summary>
    private const double Rounding = 1e-9;

    private static readonly FunctionGrid Sphere = FunctionGrid.OfHeights(4, (_, _) => 0.0);

    /// <summary>
    /// On the edge that two facets share, both have the same normal; in the middle of the cells, at the seam, beside both poles.
    /// </summary>
    [Theory]
    [InlineData(100, 300)]
    [InlineData(400, 1439)]
    [InlineData(0, 17)]
    [InlineData(-1, 0)]
    [InlineData(-1, 700)]
    [InlineData(718, 1439)]
    [InlineData(719, 5)]
    public void At_EdgeOfTwoFacets_IsTheSameFromBoth(int line, int sample)
    {
        SurfaceModel surface = new(rugged.Grid);
        SmoothNormals normals = new(surface);
        FacetId southWest = new(line, sample, FacetHalf.SouthWest);
        FacetId northEast = new(line, sample, FacetHalf.NorthEast);
        FacetId east = new(line, (sample + 1) % surface.Parts[0].Mesh.Samples, FacetHalf.SouthWest);
        Vector3D northWestCorner = Vertex(surface, line, sample);
        Vector3D northEastCorner = Vertex(surface, line, sample + 1);
        Vector3D southEastCorner = Vertex(surface, line + 1, sample + 1);
        bool hasBoth = line >= 0 && line < surface.Parts[0].Mesh.Lines - 1;
        foreach (double part in new[] { 0.0, 0.2, 0.5, 0.9, 1.0 })
        {
            if (hasBoth)
            {
                Vector3D onDiagonal = northWestCorner + (part * (southEastCorner - northWestCorner));
                AssertSame(surface, normals, southWest, northEast, onDiagonal);
            }

            Vector3D onMeridian = northEastCorner + (part * (southEastCorner - northEastCorner));
            AssertSame(
                surface,
                normals,
                line == surface.Parts[0].Mesh.Lines - 1 ? northEast : FacetAtEast(line, southWest, northEast),
                FacetAtWest(line, east),
                onMeridian);
        }
    }

    /// <summary>The pole vertex and its line are as high as each other, so that it is level there.</summary>
    [Theory]
    [InlineData(-1, FacetHalf.SouthWest, 1.0)]
    [InlineData(719, FacetHalf.NorthEast, -1.0)]
    public void At_Pole_IsTheAxis(int line, FacetHalf half, double z)
    {
        SurfaceModel surface = new(rugged.Grid);
        FacetId facet = new(line, 44, half);

        Vector3D normal = new SmoothNormals(surface).At(facet, FacetNormal(surface, facet), Vertex(surface, z > 0.0 ? -1 : 720, 44));

        Assert.Equal(0.0, Vector3D.AngleBetween(normal, new Vector3D(0.0, 0.0, z)), Rounding);
    }

    /// <param name="line">Of the cell.</param>
    /// <param name="bound">
    /// rad: the lattice moves a vertex by 2^-8 m an axis, which tilts a line over two cells; beside a pole a cell is 33 m wide, and the
    /// pole vertex is half as far as the other neighbour, which tilts by a quarter of a cell, 1.1e-3.
    /// </param>
    [Theory]
    [InlineData(360, 1.5e-6)]
    [InlineData(100, 2e-6)]
    [InlineData(10, 1e-5)]
    [InlineData(0, 1.3e-3)]
    [InlineData(-1, 1.3e-3)]
    public void At_Sphere_IsTheSpheresNormal(int line, double bound)
    {
        SurfaceModel surface = new(Sphere);
        SmoothNormals normals = new(surface);
        for (int sample = 0; sample < surface.Parts[0].Mesh.Samples; sample += 37)
        {
            FacetId facet = new(line, sample, FacetHalf.SouthWest);
            Vector3D point = (Vertex(surface, line, sample) + Vertex(surface, line + 1, sample) + Vertex(
                surface, line + 1, sample + 1)) / 3.0;

            Vector3D normal = normals.At(facet, FacetNormal(surface, facet), point);

            Assert.InRange(Vector3D.AngleBetween(normal, point), 0.0, bound);
            Assert.Equal(1.0, normal.Length, 1e-15);
        }
    }

    /// <summary>A slope from west to east: heights rise by a fixed angle, and so lean the normals.</summary>
    [Fact]
    public void At_EvenSlope_LeansByItsAngle()
    {
        SurfaceModel surface = new(FunctionGrid.OfHeights(4, (_, sample) => 800.0 * Math.Min(sample, 5)));
        FacetId facet = new(359, 2, FacetHalf.NorthEast);
        Vector3D point = (Vertex(surface, 359, 2) + Vertex(surface, 360, 3) + Vertex(surface, 359, 3)) / 3.0;

        Vector3D normal = new SmoothNormals(surface).At(facet, FacetNormal(surface, facet), point);

        // 800 m over a quarter of a degree of 1739267 m: atan(0.105415) = 6.0177 degrees; the curve of the ground adds below 0.03.
        Assert.Equal(6.0177, double.RadiansToDegrees(Vector3D.AngleBetween(normal, point)), 0.03);
        Assert.True(normal.Y < 0.0, "it leans to the west");
    }

    /// <summary>
    /// The normals of a row's points are those of single points, bit for bit, also in rows that end within a vector; at the limb the
    /// facet's.
    /// </summary>
    [Theory]
    [InlineData("nadir-100km", 64)]
    [InlineData("half-sky", 61)]
    [InlineData("grazing-sun", 131)] // longer than what is interpolated together
    public void Smooth_Row_IsWhatAtSays(string scene, int side)
    {
        RenderScenes.RenderSceneCase given = RenderScenes.Named(scene);
        PinholeCamera camera = given.Camera(rugged.Grid, side, side);
        SurfaceModel surface = new(rugged.Grid);
        VisibleSurface visible = new VisibilityPass(surface).Run(camera, threads: 1, CancellationToken.None);
        SmoothNormals normals = new(surface);
        SmoothNormals single = new(surface);
        SurfaceRow pixels = new();
        SunlitPoints points = new();
        int smooth = 0;
        for (int y = 1; y <= side; y++)
        {
            visible.Read(y, pixels);
            points.Clear(side);
            points.AddRun(pixels, new double[side], first: 0, pixels.Count);
            normals.Smooth(points, visible, y, given.Sun);
            for (int i = 0; i < pixels.Count; i++)
            {
                Vector3D point = new(pixels.X[i], pixels.Y[i], pixels.Z[i]);
                Vector3D ofFacet = new(pixels.NormalX[i], pixels.NormalY[i], pixels.NormalZ[i]);
                Vector3D expected = single.At(visible.FacetOf(y, pixels.Facets[i]), ofFacet, point);
                bool isSeen = Vector3D.Dot(expected, camera.PositionBodyFixed - point) > 0.0;
                expected = isSeen ? expected : ofFacet;
                Assert.Equal(expected, new Vector3D(points.NormalX[i], points.NormalY[i], points.NormalZ[i]));
                if (isSeen)
                {
                    double cosine = Vector3D.Dot(expected, given.Sun - point) / (given.Sun - point).Length;
                    Assert.Equal(cosine, points.CosIncidence[i], 1e-15);
                    smooth++;
                }
            }
        }

        Assert.True(smooth > side, "many points have a smooth normal");
    }

    private static FacetId FacetAtEast(int line, FacetId southWest, FacetId northEast) => line < 0 ? southWest : northEast;

    /// <summary>The neighbour's facet at its western border: the south fan has the other half only.</summary>
    private static FacetId FacetAtWest(int line, FacetId east) =>
        line == (180 * 4) - 1 ? east with { Half = FacetHalf.NorthEast } : east;

    private static void AssertSame(SurfaceModel surface, SmoothNormals normals, FacetId one, FacetId other, Vector3D point)
    {
        Vector3D first = normals.At(one, FacetNormal(surface, one), point);
        Vector3D second = normals.At(other, FacetNormal(surface, other), point);
        Assert.True(Vector3D.AngleBetween(first, second) <= Rounding, $"{one}: {first}; {other}: {second}");
        Assert.InRange(Vector3D.AngleBetween(first, point), 0.0, Math.PI / 2.0);
    }

    private static Vector3D FacetNormal(SurfaceModel surface, FacetId facet)
    {
        Vector3D northWest = Vertex(surface, facet.Line, facet.Sample);
        Vector3D southEast = Vertex(surface, facet.Line + 1, facet.Sample + 1);
        return facet.Half == FacetHalf.SouthWest
            ? Vector3D.Cross(Vertex(surface, facet.Line + 1, facet.Sample) - northWest, southEast - northWest)
            : Vector3D.Cross(southEast - northWest, Vertex(surface, facet.Line, facet.Sample + 1) - northWest);
    }

    private static Vector3D Vertex(SurfaceModel surface, int line, int sample)
    {
        double[] radius = new double[1];
        int at = (sample + surface.Parts[0].Mesh.Samples) % surface.Parts[0].Mesh.Samples;
        surface.Parts[0].Mesh.ReadRadii(line, at, radius);
        SineCosine longitude = new GridDirections(((IGlobalGrid)surface.Parts[0].Grid).PixelsPerDegree).Longitude(at);
        return LatticePoint.Nearest(radius[0], ((CylinderGeometry)surface.Parts[0].Geometry).Latitude(line), longitude).PositionBodyFixed;
    }
}
