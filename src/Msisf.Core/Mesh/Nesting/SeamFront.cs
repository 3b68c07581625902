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

    private const int None = -1;

    /// <summary>How much farther the circle of a facet may reach than that of the one beside it, if nothing else was looked for.</summary>
    private const double MaxGrowth = 1.25;

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
    private readonly int[] _next;
    private readonly int[] _previous;
    private readonly int[] _apexes;
    private readonly double[] _reaches;
    private int _stamp;

    /// <summary>Starts with the borders.</summary>
    /// <param name="vertices">The vertices.</param>
    /// <param name="edges">The edges of the borders, with the gap on their left as seen from outside.</param>
    public SeamFront(SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges)
    {
        _vertices = vertices;
        _flat = [.. vertices.Select(vertex => Terrain.MoonConstants.ReferenceRadius * vertex.Position.Normalized())];
        _seen = new int[vertices.Length];
        (_next, _previous, _apexes) = (new int[vertices.Length], new int[vertices.Length], new int[vertices.Length]);
        _reaches = new double[vertices.Length];
        Array.Fill(_apexes, None);
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

        _index.Add(_edges.Count, 0.5 * (_flat[from] + _flat[to]), Length(_flat[to] - _flat[from]));
        (_next[from], _previous[to]) = (to, from);
        _queue.Enqueue(_edges.Count);
        _edges.Add((from, to));
    }

    private void Remove(int from, int to)
    {
        _front.Remove((from, to), out int edge);
        _index.Remove(edge, 0.5 * (_flat[from] + _flat[to]), Length(_flat[to] - _flat[from]));
    }

    /// <summary>The third corner of the facet on the left of an edge.</summary>
    private int FindApex(int from, int to)
    {
        Vector3D middle = 0.5 * (_flat[from] + _flat[to]);
        double length = Length(_flat[to] - _flat[from]);
        int beside = BestBeside(from, to);
        double reachBeside = Math.Max(_reaches[from], _reaches[to]);
        if (beside != None && ReachOf(from, to, beside, length) <= MaxGrowth * reachBeside && IsFree(from, to, beside))
        {
            Note(beside, reachBeside); // not its own reach: it would grow from facet to facet
            return beside;
        }

        for (double radius = 4.0 * length; radius < 4.0 * WidestSearch; radius *= 3.0)
        {
            int apex = BestWithin(from, to, middle, radius);
            if (apex != None)
            {
                // The circle through the three reaches this far from the edge's middle.
                double reach = ReachOf(from, to, apex, length);
                if (reach <= radius || radius >= WidestSearch)
                {
                    Note(apex, reach);
                    return apex;
                }
            }
        }

        throw Crossing(from);

        void Note(int apex, double reach)
        {
            (_apexes[from], _apexes[to]) = (apex, apex);
            (_reaches[from], _reaches[to]) = (reach, reach);
        }
    }

    /// <summary>
    /// The best of the vertices beside the facets that the edge's ends had last, and along the front from there; most often the facet beside
    /// has the same apex.
    /// </summary>
    private int BestBeside(int from, int to)
    {
        int best = None;
        double bestCotangent = double.PositiveInfinity;
        Try(_apexes[from]);
        Try(_apexes[to]);
        if (best == None)
        {
            return None;
        }

        Try(_next[to]);
        Try(_previous[from]);
        for (int before = None; before != best;)
        {
            before = best;
            Try(_next[before]);
            Try(_previous[before]);
        }

        return best;

        void Try(int vertex)
        {
            if (vertex == None || vertex == from || vertex == to || Orient(from, to, vertex) <= 0)
            {
                return;
            }

            double cotangent = Cotangent(from, to, vertex);
            if (cotangent < bestCotangent && IsOnFront(vertex))
            {
                (best, bestCotangent) = (vertex, cotangent);
            }
        }
    }

    private bool IsOnFront(int vertex) => _front.ContainsKey((vertex, _next[vertex])) || _front.ContainsKey((_previous[vertex], vertex));

    private int BestWithin(int from, int to, Vector3D middle, double radius)
    {
        _index.Find(middle, new Vector3D(radius, radius, radius), _near);
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

        return None;

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
        Vector3D low = Least(_flat[a], Least(_flat[b], _flat[c]));
        Vector3D high = -Least(-_flat[a], Least(-_flat[b], -_flat[c]));
        double margin = Sagitta(high - low);
        low -= new Vector3D(margin, margin, margin);
        high += new Vector3D(margin, margin, margin);
        _index.Find(0.5 * (low + high), 0.5 * (high - low), _crossing);
        foreach (int edge in _crossing)
        {
            (int from, int to) = _edges[edge];
            Vector3D start = _flat[from];
            Vector3D end = _flat[to];
            double around = Sagitta(end - start);
            if (Math.Max(start.X, end.X) < low.X - around || Math.Min(start.X, end.X) > high.X + around
                || Math.Max(start.Y, end.Y) < low.Y - around || Math.Min(start.Y, end.Y) > high.Y + around
                || Math.Max(start.Z, end.Z) < low.Z - around || Math.Min(start.Z, end.Z) > high.Z + around)
            {
                continue;
            }

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
        return Vector3D.Dot(u, v) / Length(Vector3D.Cross(u, v));
    }

    /// <summary>m: how far below the sphere a straight line lies at most; a third is added.</summary>
    private static double Sagitta(Vector3D side) => side.LengthSquared / (6.0 * Terrain.MoonConstants.ReferenceRadius);

    private static Vector3D Least(Vector3D u, Vector3D v) => new(Math.Min(u.X, v.X), Math.Min(u.Y, v.Y), Math.Min(u.Z, v.Z));

    /// <summary>Lengths here are 1 mm to 1e6 m: their squares neither overflow nor vanish.</summary>
    private static double Length(Vector3D v) => Math.Sqrt(v.LengthSquared);

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
