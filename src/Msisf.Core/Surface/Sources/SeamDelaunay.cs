namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Turns facets that fill gaps into a constrained Delaunay triangulation as seen from the Moon's centre: on the reference sphere the
/// circle through the corners of a facet holds no vertex of the facets beside it.
/// </summary>
/// <remarks>
/// The side between two facets is replaced by the other diagonal of their four corners while that is not so: C. L. Lawson, "Software for C1
/// surface interpolation", Mathematical Software III (1977), 161. Each such step lifts the surface of the flat facets through the places
/// on the sphere, so that they come to an end.
/// </remarks>
internal sealed class SeamDelaunay
{
    /// <summary>Relative rounding error of the determinant of three differences of places.</summary>
    private const double Rounding = 16.0 / (1L << 53);

    private readonly SeamGeometry _geometry;
    private readonly int[] _corners;
    private readonly Dictionary<(int From, int To), int> _facets;
    private readonly Queue<(int From, int To)> _sides = [];

    private SeamDelaunay(SeamGeometry geometry, int[] corners)
    {
        (_geometry, _corners) = (geometry, corners);
        _facets = new Dictionary<(int, int), int>(corners.Length);
        for (int i = 0; i < corners.Length; i++)
        {
            (int from, int to) = (corners[i], corners[Next(i)]);
            _facets[(from, to)] = i / 3;
            _sides.Enqueue((from, to));
        }
    }

    /// <summary>The facets of the same gaps.</summary>
    /// <param name="corners">Three corners of each facet, counter-clockwise seen from outside.</param>
    public static int[] Of(SeamVertex[] vertices, int[] corners)
    {
        SeamDelaunay mesh = new(new SeamGeometry(vertices), [.. corners]);
        while (mesh._sides.TryDequeue(out (int From, int To) side))
        {
            mesh.TryTurn(side.From, side.To);
        }

        return mesh._corners;
    }

    private static int Next(int corner) => corner % 3 == 2 ? corner - 2 : corner + 1;

    /// <summary>Replaces a side by the other diagonal if that is better; a side with one facet is a border and stays.</summary>
    private void TryTurn(int from, int to)
    {
        if (!_facets.TryGetValue((from, to), out int facet) || !_facets.TryGetValue((to, from), out int beside))
        {
            return;
        }

        (int apex, int other) = (ApexOf(facet, from, to), ApexOf(beside, to, from));
        if (!IsWithin(from, to, apex, other) || _geometry.Orient(from, other, apex) <= 0 || _geometry.Orient(other, to, apex) <= 0)
        {
            return;
        }

        _facets.Remove((from, to));
        _facets.Remove((to, from));
        Put(facet, from, other, apex);
        Put(beside, other, to, apex);
        foreach ((int, int) side in (ReadOnlySpan<(int, int)>)[(from, other), (other, to), (to, apex), (apex, from)])
        {
            _sides.Enqueue(side);
        }
    }

    private void Put(int facet, int a, int b, int c)
    {
        (_corners[3 * facet], _corners[(3 * facet) + 1], _corners[(3 * facet) + 2]) = (a, b, c);
        _facets[(a, b)] = _facets[(b, c)] = _facets[(c, a)] = facet;
    }

    private int ApexOf(int facet, int from, int to)
    {
        ReadOnlySpan<int> corners = _corners.AsSpan(3 * facet, 3);
        return corners[0] != from && corners[0] != to ? corners[0] : corners[1] != from && corners[1] != to ? corners[1] : corners[2];
    }

    /// <summary>Whether a vertex surely lies within the circle: on the outer side of the plane through the three places.</summary>
    private bool IsWithin(int a, int b, int c, int vertex)
    {
        Vector3D place = _geometry.PlaceOf(a);
        Vector3D ab = _geometry.PlaceOf(b) - place;
        Vector3D ac = _geometry.PlaceOf(c) - place;
        Vector3D ad = _geometry.PlaceOf(vertex) - place;
        double sizes = Math.Sqrt(ab.LengthSquared * ac.LengthSquared * ad.LengthSquared); // below 1e20 m^3
        return Vector3D.Dot(Vector3D.Cross(ab, ac), ad) > Rounding * sizes;
    }
}
