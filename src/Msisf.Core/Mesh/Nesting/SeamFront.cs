using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Core.Mesh.Nesting;

/// <summary>
/// Fills the gaps between models with facets: from the edges of their borders inwards, each edge with the vertex that sees it at the
/// largest angle, as in a constrained Delaunay triangulation as seen from the Moon's centre. All vertices of the borders are used, none is
/// added, so there is no T-junction. Signs are exact, and so the facets cover the gaps without overlap.
/// </summary>
/// <remarks>
/// An edge has the gap on its left. A facet is taken if no other vertex of the front lies in it and no edge of the front crosses it; then
/// what remains is a gap with edges again, until none is left. Such a facet exists for each edge of a gap.
/// </remarks>
internal sealed class SeamFront
{
    /// <summary>m: no gap is wider.</summary>
    private const double WidestSearch = 4e6;

    private readonly SeamVertex[] _vertices;
    private readonly Vector3D[] _flat;
    private readonly FrontIndex _index = new();
    private readonly List<(int From, int To)> _edges = [];
    private readonly Dictionary<(int From, int To), int> _front = [];
    private readonly Queue<int> _queue = [];
    private readonly List<int> _corners = [];
    private readonly List<int> _near = [];
    private readonly List<int> _crossing = [];
    private readonly List<int> _candidates = [];
    private readonly int[] _seen;
    private int _stamp;

    /// <summary>Starts with the borders.</summary>
    /// <param name="vertices">The vertices.</param>
    /// <param name="edges">The edges of the borders, with the gap on their left as seen from outside.</param>
    public SeamFront(SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges)
    {
        _vertices = vertices;
        _flat = [.. vertices.Select(vertex => Terrain.MoonConstants.ReferenceRadius * vertex.Position.Normalized())];
        _seen = new int[vertices.Length];
        foreach ((int from, int to) in edges)
        {
            Add(from, to);
        }
    }

    /// <summary>Fills all gaps.</summary>
    /// <returns>Three indices of vertices for each facet.</returns>
    /// <exception cref="BadInputException">A gap can't be filled: borders cross.</exception>
    public int[] Fill()
    {
        while (_queue.TryDequeue(out int edge))
        {
            (int from, int to) = _edges[edge];
            if (!_front.TryGetValue((from, to), out int current) || current != edge)
            {
                continue;
            }

            int apex = FindApex(from, to);
            Remove(from, to);
            Cover(from, apex);
            Cover(apex, to);
            _corners.AddRange([from, to, apex]);
        }

        return [.. _corners];
    }

    /// <summary>Goes on behind a new side of a facet, or ends where that side is a border.</summary>
    private void Cover(int from, int to)
    {
        if (_front.ContainsKey((to, from)))
        {
            Remove(to, from);
        }
        else
        {
            Add(from, to);
        }
    }

    private void Add(int from, int to)
    {
        if (!_front.TryAdd((from, to), _edges.Count))
        {
            throw Crossing(from);
        }

        _index.Add(_edges.Count, 0.5 * (_flat[from] + _flat[to]), (_flat[to] - _flat[from]).Length);
        _queue.Enqueue(_edges.Count);
        _edges.Add((from, to));
    }

    private void Remove(int from, int to)
    {
        _front.Remove((from, to), out int edge);
        _index.Remove(edge, 0.5 * (_flat[from] + _flat[to]), (_flat[to] - _flat[from]).Length);
    }

    /// <summary>The third corner of the facet on the left of an edge.</summary>
    private int FindApex(int from, int to)
    {
        Vector3D middle = 0.5 * (_flat[from] + _flat[to]);
        double length = (_flat[to] - _flat[from]).Length;
        for (double radius = 4.0 * length; radius < 4.0 * WidestSearch; radius *= 3.0)
        {
            int apex = BestWithin(from, to, middle, radius);
            if (apex >= 0)
            {
                // The circle through the three reaches this far from the edge's middle.
                double reach = ReachOf(from, to, apex, length);
                if (reach <= radius || radius >= WidestSearch)
                {
                    return apex;
                }
            }
        }

        throw Crossing(from);
    }

    private int BestWithin(int from, int to, Vector3D middle, double radius)
    {
        _index.Find(middle, radius, _near);
        _candidates.Clear();
        _stamp++;
        _seen[from] = _seen[to] = _stamp;
        foreach (int edge in _near)
        {
            Consider(_edges[edge].From);
            Consider(_edges[edge].To);
        }

        while (_candidates.Count > 0)
        {
            int best = 0;
            double bestCotangent = double.PositiveInfinity;
            for (int i = 0; i < _candidates.Count; i++)
            {
                double cotangent = Cotangent(from, to, _candidates[i]);
                if (cotangent < bestCotangent || (cotangent == bestCotangent && _candidates[i] < _candidates[best]))
                {
                    (best, bestCotangent) = (i, cotangent);
                }
            }

            int apex = _candidates[best];
            if (IsFree(from, to, apex))
            {
                return apex;
            }

            _candidates[best] = _candidates[^1];
            _candidates.RemoveAt(_candidates.Count - 1);
        }

        return -1;

        void Consider(int vertex)
        {
            if (_seen[vertex] != _stamp)
            {
                _seen[vertex] = _stamp;
                if (Orient(from, to, vertex) > 0)
                {
                    _candidates.Add(vertex);
                }
            }
        }
    }

    /// <summary>Whether nothing of the front lies in a facet or crosses it.</summary>
    private bool IsFree(int a, int b, int c)
    {
        Vector3D centre = (_flat[a] + _flat[b] + _flat[c]) / 3.0;
        double radius = Math.Max((_flat[a] - centre).Length, Math.Max((_flat[b] - centre).Length, (_flat[c] - centre).Length));
        _index.Find(centre, radius, _crossing);
        foreach (int edge in _crossing)
        {
            (int from, int to) = _edges[edge];
            if (Holds(a, b, c, from) || Holds(a, b, c, to) || Cross(from, to, b, c) || Cross(from, to, c, a))
            {
                return false;
            }
        }

        return true;
    }

    private bool Holds(int a, int b, int c, int vertex) => vertex != a && vertex != b && vertex != c
        && Orient(a, b, vertex) >= 0 && Orient(b, c, vertex) >= 0 && Orient(c, a, vertex) >= 0;

    private bool Cross(int a, int b, int c, int d) => a != c && a != d && b != c && b != d
        && Orient(a, b, c) * Orient(a, b, d) < 0 && Orient(c, d, a) * Orient(c, d, b) < 0;

    private int Orient(int a, int b, int c) =>
        Orientation.Of(_vertices[a].Position, _vertices[b].Position, _vertices[c].Position);

    /// <summary>Cotangent of the angle at which a vertex sees an edge.</summary>
    private double Cotangent(int from, int to, int vertex)
    {
        Vector3D u = _flat[from] - _flat[vertex];
        Vector3D v = _flat[to] - _flat[vertex];
        return Vector3D.Dot(u, v) / Vector3D.Cross(u, v).Length;
    }

    /// <summary>
    /// Distance from an edge's middle to the farthest point, on its left, of the circle through its ends and a vertex, m: half the length
    /// times the cotangent of half the angle at the vertex.
    /// </summary>
    private double ReachOf(int from, int to, int vertex, double length)
    {
        double cotangent = Cotangent(from, to, vertex);
        return 0.5 * length * (cotangent + Math.Sqrt(1.0 + (cotangent * cotangent))) * 1.000001;
    }

    private BadInputException Crossing(int vertex) => new(
        $"The elevation models can't be joined around {SelenographicText(_vertices[vertex].Position)}: their borders cross there. "
            + "Leave one of the models out.");

    private static string SelenographicText(Vector3D position)
    {
        Terrain.SelenographicPoint point = Terrain.SelenographicPoint.Below(position);
        return string.Create(
            System.Globalization.CultureInfo.InvariantCulture,
            $"latitude {double.RadiansToDegrees(point.Latitude):F3}, longitude {double.RadiansToDegrees(point.Longitude):F3} degrees");
    }
}
