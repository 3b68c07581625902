using System.Runtime.CompilerServices;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// Interpolates normals between the vertices. The normal of a vertex is perpendicular to the line through its west and east neighbours
/// and to the line through its north and south neighbours. The normal at a point of a facet is the mean of the facet's vertex normals,
/// weighted by the point's barycentric coordinates. Vertices are kept, so each thread needs its own object.
/// </summary>
/// <remarks>B. T. Phong, "Illumination for computer generated pictures", Comm. ACM 18 (1975) 311.</remarks>
internal sealed class SmoothNormals
{
    /// <summary>Number of vertices that are kept: a row of pixels crosses the same cells as the row above it.</summary>
    private const int KeptVertices = 1 << 13;

    private readonly SurfaceModel _surface;
    private GridPatch _part;
    private int _partNumber;
    private readonly Corner[] _kept = new Corner[KeptVertices];
    private readonly long[] _keptKeys = new long[KeptVertices];
    private readonly double[] _radii = new double[3];
    private readonly Corner[] _corners = new Corner[3];
    private FacetId _facet = new(int.MinValue, 0, default);

    public SmoothNormals(SurfaceModel surface)
    {
        _surface = surface;
        _part = surface.Parts[0];
        Array.Fill(_keptKeys, -1);
    }

    /// <summary>The interpolated normal at a point of a facet.</summary>
    /// <param name="facetNormalBodyFixed">The facet's own normal, body-fixed, outward, of any length.</param>
    /// <param name="pointBodyFixed">The point on the facet, m, body-fixed.</param>
    /// <returns>The normal, body-fixed, outward, length 1.</returns>
    public Vector3D At(FacetId facet, Vector3D facetNormalBodyFixed, Vector3D pointBodyFixed)
    {
        if (facet != _facet)
        {
            Load(facet);
        }

        ref readonly Corner a = ref _corners[0];
        ref readonly Corner b = ref _corners[1];
        ref readonly Corner c = ref _corners[2];
        Vector3D toA = a.Position - pointBodyFixed;
        Vector3D toB = b.Position - pointBodyFixed;
        Vector3D toC = c.Position - pointBodyFixed;
        double weightA = Weight(facetNormalBodyFixed, toB, toC);
        double weightB = Weight(facetNormalBodyFixed, toC, toA);
        double weightC = Weight(facetNormalBodyFixed, toA, toB);
        return ((weightA * a.Normal) + (weightB * b.Normal) + (weightC * c.Normal)).Normalized();
    }

    /// <summary>Twice the area of the triangle between an edge and the point, times the length of the normal.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Weight(Vector3D normal, Vector3D toOneEnd, Vector3D toOther) =>
        Vector3D.Dot(normal, Vector3D.Cross(toOneEnd, toOther));

    /// <summary>A vertex of a seam has the normal that it has in its own model.</summary>
    private void Load(FacetId facet)
    {
        _facet = facet;
        for (int corner = 0; corner < _corners.Length; corner++)
        {
            (_partNumber, int line, int sample) = _surface.Patches[facet.Part].VertexOf(facet, corner);
            _part = _surface.Parts[_partNumber];
            _corners[corner] = CornerAt(line, sample);
        }
    }

    private Corner CornerAt(int line, int sample)
    {
        // 64 samples of a line lie beside each other, so a cell and its neighbours do not replace each other.
        int place = ((line << 6) ^ sample) & (KeptVertices - 1);
        long key = ((long)_partNumber << 56) | ((long)(line + 1) << 32) | (uint)sample;
        if (_keptKeys[place] != key)
        {
            _kept[place] = ReadCorner(line, sample);
            _keptKeys[place] = key;
        }

        return _kept[place];
    }

    private Corner ReadCorner(int line, int sample)
    {
        if (!_part.Mesh.IsClosed)
        {
            return ReadCornerOfMap(line, sample);
        }

        int samples = _part.Mesh.Samples;
        _part.Mesh.ReadRadii(line, sample - 1, _radii);
        Vector3D position = _part.Vertex(line, sample, _radii[1]);
        if (line < 0 || line >= _part.Mesh.Lines)
        {
            // A pole has no west and east; its height is the mean of the nearest line, so the surface there is taken as level.
            return new Corner(position, line < 0 ? Vector3D.UnitZ : -Vector3D.UnitZ);
        }

        Vector3D eastward = _part.Vertex(line, sample + 1, _radii[2])
            - _part.Vertex(line, sample == 0 ? samples - 1 : sample - 1, _radii[0]);
        Vector3D northward = VertexAt(line - 1, sample) - VertexAt(line + 1, sample);
        Vector3D normal = Vector3D.Cross(eastward, northward);

        // Next to a pole of a fine model, neighbouring vertices can be at the same point of the vertex lattice.
        return new Corner(position, normal == default ? position.Normalized() : normal.Normalized());
    }

    /// <summary>A vertex of a map that ends: on its border the vertex itself takes the place of the neighbour that is missing.</summary>
    private Corner ReadCornerOfMap(int line, int sample)
    {
        FacetMesh mesh = _part.Mesh;
        (int west, int east) = mesh.NeighboursOf(sample);
        Vector3D eastward = VertexAt(line, east) - VertexAt(line, west);
        Vector3D northward =
            VertexAt(Math.Max(line - 1, mesh.Cells.FirstLine), sample) - VertexAt(Math.Min(line + 1, mesh.Cells.EndLine), sample);
        return new Corner(VertexAt(line, sample), Vector3D.Cross(eastward, northward).Normalized());
    }

    private Vector3D VertexAt(int line, int sample)
    {
        Span<double> radius = _radii.AsSpan(0, 1);
        _part.Mesh.ReadRadii(line, sample, radius);
        return _part.Vertex(line, sample, radius[0]);
    }

    private readonly record struct Corner(Vector3D Position, Vector3D Normal);
}
