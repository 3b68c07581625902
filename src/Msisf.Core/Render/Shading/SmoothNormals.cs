using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// Interpolates normals between the vertices. The normal of a vertex is perpendicular to the line through its west and east neighbours
/// and to the line through its north and south neighbours. The normal at a point of a facet is the mean of the facet's vertex normals,
/// weighted by the point's barycentric coordinates. The last cell is kept, so each thread needs its own object.
/// </summary>
/// <remarks>B. T. Phong, "Illumination for computer generated pictures", Comm. ACM 18 (1975) 311.</remarks>
internal sealed class SmoothNormals
{
    private const int PatchSize = 4;

    private readonly SurfaceModel _surface;
    private readonly double[] _radii = new double[PatchSize];
    private readonly Vector3D[] _vertices = new Vector3D[PatchSize * PatchSize];
    private int _line = int.MinValue;
    private int _sample;
    private Corner _northWest;
    private Corner _northEast;
    private Corner _southWest;
    private Corner _southEast;

    public SmoothNormals(SurfaceModel surface) => _surface = surface;

    /// <summary>The interpolated normal at a point of a facet.</summary>
    /// <param name="facet">The facet.</param>
    /// <param name="facetNormalMoonMe">The facet's own normal, MOON_ME, outward, of any length.</param>
    /// <param name="pointMoonMe">The point on the facet, m, MOON_ME.</param>
    /// <returns>The normal, MOON_ME, outward, length 1.</returns>
    public Vector3D At(FacetId facet, Vector3D facetNormalMoonMe, Vector3D pointMoonMe)
    {
        if (facet.Line != _line || facet.Sample != _sample)
        {
            Load(facet.Line, facet.Sample);
        }

        (Corner b, Corner c) = facet.Half == FacetHalf.SouthWest ? (_southWest, _southEast) : (_southEast, _northEast);
        Corner a = _northWest;
        double weightA = Weight(facetNormalMoonMe, b.Position, c.Position, pointMoonMe);
        double weightB = Weight(facetNormalMoonMe, c.Position, a.Position, pointMoonMe);
        double weightC = Weight(facetNormalMoonMe, a.Position, b.Position, pointMoonMe);
        return ((weightA * a.Normal) + (weightB * b.Normal) + (weightC * c.Normal)).Normalized();
    }

    /// <summary>Twice the area of the triangle between an edge and the point, times the length of the normal.</summary>
    private static double Weight(Vector3D normal, Vector3D from, Vector3D to, Vector3D point) =>
        Vector3D.Dot(normal, Vector3D.Cross(from - point, to - point));

    private void Load(int line, int sample)
    {
        for (int row = 0; row < PatchSize; row++)
        {
            // There is no line beyond a pole: the values there are not used.
            int vertexLine = Math.Clamp(line - 1 + row, -1, _surface.Mesh.Lines);
            _surface.Mesh.ReadRadii(vertexLine, sample - 1, _radii);
            for (int column = 0; column < PatchSize; column++)
            {
                int at = (sample - 1 + column + _surface.Mesh.Samples) % _surface.Mesh.Samples;
                _vertices[(row * PatchSize) + column] = _surface.Vertex(vertexLine, at, _radii[column]);
            }
        }

        _line = line;
        _sample = sample;
        _northWest = CornerAt(1, 1);
        _northEast = CornerAt(1, 2);
        _southWest = CornerAt(2, 1);
        _southEast = CornerAt(2, 2);
    }

    private Corner CornerAt(int row, int column)
    {
        Vector3D position = _vertices[(row * PatchSize) + column];
        int line = _line - 1 + row;
        if (line < 0 || line >= _surface.Mesh.Lines)
        {
            // A pole has no west and east; its height is the mean of the nearest line, so the surface there is taken as level.
            return new Corner(position, line < 0 ? Vector3D.UnitZ : -Vector3D.UnitZ);
        }

        Vector3D eastward = _vertices[(row * PatchSize) + column + 1] - _vertices[(row * PatchSize) + column - 1];
        Vector3D northward = _vertices[((row - 1) * PatchSize) + column] - _vertices[((row + 1) * PatchSize) + column];
        Vector3D normal = Vector3D.Cross(eastward, northward);

        // Next to a pole of a fine model, neighbouring vertices can be at the same point of the vertex lattice.
        return new Corner(position, normal == default ? position.Normalized() : normal.Normalized());
    }

    private readonly record struct Corner(Vector3D Position, Vector3D Normal);
}
