using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Where the vertices of seams lie to each other as seen from the Moon's centre. Signs are exact; lengths and angles are those of their
/// places on the reference sphere.
/// </summary>
internal sealed class SeamGeometry
{
    private readonly SeamVertex[] _vertices;
    private readonly Vector3D[] _flat;

    /// <summary>Takes the vertices, which are numbered as here.</summary>
    public SeamGeometry(SeamVertex[] vertices)
    {
        _vertices = vertices;
        _flat = [.. vertices.Select(vertex => MoonConstants.ReferenceRadius * vertex.Position.Normalized())];
    }

    /// <summary>Number of vertices.</summary>
    public int Count => _vertices.Length;

    /// <summary>A vertex's place on the reference sphere, m.</summary>
    public Vector3D PlaceOf(int vertex) => _flat[vertex];

    /// <summary>Middle of an edge, m.</summary>
    public Vector3D MiddleOf(int from, int to) => 0.5 * (_flat[from] + _flat[to]);

    /// <summary>Length of an edge, m; 1 mm to 1e6 m, so that the square neither overflows nor vanishes.</summary>
    public double LengthOf(int from, int to) => Math.Sqrt((_flat[to] - _flat[from]).LengthSquared);

    /// <summary>Normal of the plane through the Moon's centre and an edge, towards the edge's left, m^2.</summary>
    public Vector3D NormalOf(int from, int to) => Vector3D.Cross(_flat[from], _flat[to]);

    /// <summary>See <see cref="Orientation.Of"/>.</summary>
    public int Orient(int a, int b, int c) => Orientation.Of(_vertices[a].Position, _vertices[b].Position, _vertices[c].Position);

    /// <summary>Whether a facet, with its sides, holds a vertex that is not one of its corners.</summary>
    public bool Holds(int a, int b, int c, int vertex) => vertex != a && vertex != b && vertex != c
        && Orient(a, b, vertex) >= 0 && Orient(b, c, vertex) >= 0 && Orient(c, a, vertex) >= 0;

    /// <summary>Whether two edges without a common end cross each other.</summary>
    public bool Cross(int a, int b, int c, int d) => a != c && a != d && b != c && b != d
        && Orient(a, b, c) * Orient(a, b, d) < 0 && Orient(c, d, a) * Orient(c, d, b) < 0;

    /// <summary>Cotangent of the angle at which a vertex sees an edge.</summary>
    public double Cotangent(int from, int to, int vertex)
    {
        Vector3D u = _flat[from] - _flat[vertex];
        Vector3D v = _flat[to] - _flat[vertex];
        return Vector3D.Dot(u, v) / Math.Sqrt(Vector3D.Cross(u, v).LengthSquared);
    }

    /// <summary>
    /// Distance from an edge's middle to the farthest point, on its left, of the circle through its ends and a vertex, m: half the length
    /// times the cotangent of half the angle at the vertex.
    /// </summary>
    public double ReachOf(int from, int to, int vertex)
    {
        const double Rounding = 1.000001;
        double cotangent = Cotangent(from, to, vertex);
        return 0.5 * LengthOf(from, to) * (cotangent + Math.Sqrt(1.0 + (cotangent * cotangent))) * Rounding;
    }

    /// <summary>A box around a facet, with room for what lies below the sphere.</summary>
    public (Vector3D Low, Vector3D High) BoxOf(int a, int b, int c)
    {
        Vector3D low = Least(_flat[a], Least(_flat[b], _flat[c]));
        Vector3D high = -Least(-_flat[a], Least(-_flat[b], -_flat[c]));
        double margin = Sagitta(high - low);
        Vector3D around = new(margin, margin, margin);
        return (low - around, high + around);
    }

    /// <summary>Whether an edge may reach into a box.</summary>
    public bool MayMeet(int from, int to, in (Vector3D Low, Vector3D High) box)
    {
        Vector3D start = _flat[from];
        Vector3D end = _flat[to];
        double around = Sagitta(end - start);
        return Math.Max(start.X, end.X) >= box.Low.X - around && Math.Min(start.X, end.X) <= box.High.X + around
            && Math.Max(start.Y, end.Y) >= box.Low.Y - around && Math.Min(start.Y, end.Y) <= box.High.Y + around
            && Math.Max(start.Z, end.Z) >= box.Low.Z - around && Math.Min(start.Z, end.Z) <= box.High.Z + around;
    }

    /// <summary>The error that no facets can join the models at a vertex.</summary>
    public BadInputException Crossing(int vertex)
    {
        SelenographicPoint point = SelenographicPoint.Below(_vertices[vertex].Position);
        return new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"The elevation models can't be joined around latitude {double.RadiansToDegrees(point.Latitude):F3}, longitude "
                + $"{double.RadiansToDegrees(point.Longitude):F3} degrees: their borders cross there. Leave one of the models out."));
    }

    /// <summary>m: how far below the sphere a straight line lies at most; a third is added.</summary>
    private static double Sagitta(Vector3D side) => side.LengthSquared / (6.0 * MoonConstants.ReferenceRadius);

    private static Vector3D Least(Vector3D u, Vector3D v) => new(Math.Min(u.X, v.X), Math.Min(u.Y, v.Y), Math.Min(u.Z, v.Z));
}
