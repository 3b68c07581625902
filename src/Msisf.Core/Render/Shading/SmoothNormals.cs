using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// Interpolates normals between the vertices. The normal of a vertex is perpendicular to the line through its west and east neighbours
/// and to the line through its north and south neighbours. The normal at a point of a facet is the mean of the facet's vertex normals,
/// weighted by the point's barycentric coordinates. Vertices and facets are kept, so each thread needs its own object.
/// </summary>
/// <remarks>B. T. Phong, "Illumination for computer generated pictures", Comm. ACM 18 (1975) 311.</remarks>
internal sealed class SmoothNormals
{
    /// <summary>Number of vertices that are kept: a row of pixels crosses the same cells as the row above it.</summary>
    private const int KeptVertices = 1 << 13;

    /// <summary>Number of facets that are kept.</summary>
    private const int KeptFacets = 1 << 12;

    private const int CornersOfFacet = 3;

    /// <summary>Numbers of a facet's corners: position and normal of each.</summary>
    private const int Numbers = CornersOfFacet * 6;

    /// <summary>Points that are interpolated together; their facets' numbers stay in the processor's first cache.</summary>
    private const int Together = 64;

    private readonly SurfaceModel _surface;
    private GridPatch _part;
    private int _partNumber;
    private readonly Corner[] _kept = new Corner[KeptVertices];
    private readonly long[] _keptKeys = new long[KeptVertices];
    private readonly FacetId[] _facets = new FacetId[KeptFacets];
    private readonly Corner[] _corners = new Corner[KeptFacets * CornersOfFacet];
    private readonly double[] _ofPoints = new double[Numbers * Together];
    private readonly double[] _radii = new double[3];

    public SmoothNormals(SurfaceModel surface)
    {
        _surface = surface;
        _part = surface.Parts[0];
        Array.Fill(_keptKeys, -1);
        Array.Fill(_facets, new FacetId(int.MinValue, 0, default));
    }

    /// <summary>
    /// Gives points their smooth normals and the cosines of the incidence angles on them, with the bits of <see cref="At"/>. Where the
    /// smooth normal points away from the camera, as it can at the limb, the facet's stays: reflectance laws are undefined there.
    /// </summary>
    /// <param name="points">The points of a row.</param>
    /// <param name="rows">Knows their facets.</param>
    /// <param name="y">The row, from 1.</param>
    /// <param name="lightBodyFixed">Position of the Sun or lamp, m.</param>
    public void Smooth(SunlitPoints points, ISurfaceRows rows, int y, Vector3D lightBodyFixed)
    {
        Vector3D camera = rows.View.Camera.PositionBodyFixed;
        int facet = -1;
        int corners = 0;
        for (int first = 0; first < points.Count; first += Together)
        {
            int end = Math.Min(points.Count, first + Together);
            for (int i = first; i < end;)
            {
                if (points.Facets[i] != facet)
                {
                    facet = points.Facets[i];
                    corners = CornersOf(rows.FacetOf(y, facet));
                }

                int start = i++;
                while (i < end && points.Facets[i] == facet)
                {
                    i++;
                }

                CopyCorners(corners, start - first, i - first);
            }

            // What fills up the last vector lies on the last facet.
            int count = end - first;
            CopyCorners(corners, count, (count + Vector256<double>.Count - 1) / Vector256<double>.Count * Vector256<double>.Count);
            for (int i = first; i < end; i += Vector256<double>.Count)
            {
                uint isMeant = end - i >= Vector256<double>.Count ? 0xfu : (1u << (end - i)) - 1;
                Smooth(points, i, i - first, isMeant, camera, lightBodyFixed);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private void Smooth(SunlitPoints points, int at, int place, uint isMeant, Vector3D camera, Vector3D light)
    {
        LaneVectors point = new(ArrayLanes.Load256(points.X, at), ArrayLanes.Load256(points.Y, at), ArrayLanes.Load256(points.Z, at));
        LaneVectors ofFacet = new(
            ArrayLanes.Load256(points.NormalX, at), ArrayLanes.Load256(points.NormalY, at), ArrayLanes.Load256(points.NormalZ, at));
        LaneVectors toA = OfPoints(0, place) - point;
        LaneVectors toB = OfPoints(2, place) - point;
        LaneVectors toC = OfPoints(4, place) - point;
        Vector256<double> weightA = LaneVectors.Dot(ofFacet, LaneVectors.Cross(toB, toC));
        Vector256<double> weightB = LaneVectors.Dot(ofFacet, LaneVectors.Cross(toC, toA));
        Vector256<double> weightC = LaneVectors.Dot(ofFacet, LaneVectors.Cross(toA, toB));
        LaneVectors sum = (weightA * OfPoints(1, place)) + (weightB * OfPoints(3, place)) + (weightC * OfPoints(5, place));
        Vector256<double> length = Vector256.Hypot(Vector256.Hypot(sum.X, sum.Y), sum.Z);
        Vector256<double> hasDirection = Vector256.GreaterThan(length, Vector256<double>.Zero)
            & Vector256.LessThan(length, Vector256.Create(double.PositiveInfinity));
        if ((~(uint)hasDirection.ExtractMostSignificantBits() & isMeant) != 0)
        {
            throw new InvalidOperationException($"A facet of row {points.Columns[at]} has no smooth normal.");
        }

        LaneVectors smooth = sum / length;
        Vector256<double> isSeen = Vector256.GreaterThan(
            LaneVectors.Dot(smooth, LaneVectors.Of(camera) - point), Vector256<double>.Zero);
        LaneVectors toLight = LaneVectors.Of(light) - point;

        // Lengths of 1 m to 1e12 m: their squares neither overflow nor vanish.
        Vector256<double> cosine = Vector256.MinNative(
            LaneVectors.Dot(smooth, toLight / Vector256.Sqrt(LaneVectors.Dot(toLight, toLight))), Vector256<double>.One);
        Vector256<double> isOther = isSeen & ~(Vector256.Equals(smooth.X, ofFacet.X) & Vector256.Equals(smooth.Y, ofFacet.Y)
            & Vector256.Equals(smooth.Z, ofFacet.Z));
        Vector256.ConditionalSelect(isOther, smooth.X, ofFacet.X).StoreTo(points.NormalX, at);
        Vector256.ConditionalSelect(isOther, smooth.Y, ofFacet.Y).StoreTo(points.NormalY, at);
        Vector256.ConditionalSelect(isOther, smooth.Z, ofFacet.Z).StoreTo(points.NormalZ, at);
        Vector256.ConditionalSelect(isOther, cosine, ArrayLanes.Load256(points.CosIncidence, at)).StoreTo(points.CosIncidence, at);
    }

    /// <summary>Three numbers of the facets' corners at four points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private LaneVectors OfPoints(int vector, int place) => new(
        ArrayLanes.Load256(_ofPoints, (3 * vector * Together) + place),
        ArrayLanes.Load256(_ofPoints, (((3 * vector) + 1) * Together) + place),
        ArrayLanes.Load256(_ofPoints, (((3 * vector) + 2) * Together) + place));

    /// <summary>Copies the numbers of a facet's corners to the places of some points.</summary>
    private void CopyCorners(int corners, int start, int end)
    {
        ReadOnlySpan<double> numbers = MemoryMarshal.Cast<Corner, double>(_corners.AsSpan(corners, CornersOfFacet));
        for (int number = 0; number < Numbers; number++)
        {
            double value = numbers[number];
            Span<double> ofPoints = _ofPoints.AsSpan(number * Together, Together);
            for (int place = start; place < end; place++)
            {
                ofPoints[place] = value;
            }
        }
    }

    /// <summary>The interpolated normal at a point of a facet.</summary>
    /// <param name="facetNormalBodyFixed">The facet's own normal, body-fixed, outward, of any length.</param>
    /// <param name="pointBodyFixed">The point on the facet, m, body-fixed.</param>
    /// <returns>The normal, body-fixed, outward, length 1.</returns>
    public Vector3D At(FacetId facet, Vector3D facetNormalBodyFixed, Vector3D pointBodyFixed)
    {
        int corners = CornersOf(facet);
        ref readonly Corner a = ref _corners[corners];
        ref readonly Corner b = ref _corners[corners + 1];
        ref readonly Corner c = ref _corners[corners + 2];
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

    /// <summary>
    /// Index of the first of a facet's corners in the kept ones. A vertex of a seam has the normal that it has in its own model.
    /// </summary>
    private int CornersOf(FacetId facet)
    {
        // As with the vertices; both facets of a cell lie beside each other.
        int place = ((((facet.Line << 6) ^ facet.Sample) << 1) | (int)facet.Half) & (KeptFacets - 1);
        int corners = place * CornersOfFacet;
        if (_facets[place] != facet)
        {
            for (int corner = 0; corner < CornersOfFacet; corner++)
            {
                (_partNumber, int line, int sample) = _surface.Patches[facet.Part].VertexOf(facet, corner);
                _part = _surface.Parts[_partNumber];
                _corners[corners + corner] = CornerAt(line, sample);
            }

            _facets[place] = facet;
        }

        return corners;
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
