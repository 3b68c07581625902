namespace Msisf.Core.Surface.Sources;

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

    private readonly SeamGeometry _geometry;
    private readonly FrontEdges _front;
    private readonly List<int> _corners = [];
    private readonly List<int> _near = [];
    private readonly List<int> _crossing = [];
    private readonly List<int> _candidates = [];
    private readonly int[] _seen;
    private readonly int[] _apexes;
    private readonly double[] _reaches;
    private int _stamp;

    /// <summary>Starts with the borders.</summary>
    /// <param name="edges">The edges of the borders, with the gap on their left as seen from outside.</param>
    public SeamFront(SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges)
    {
        _geometry = new SeamGeometry(vertices);
        _front = new FrontEdges(_geometry);
        (_seen, _apexes, _reaches) = (new int[vertices.Length], new int[vertices.Length], new double[vertices.Length]);
        Array.Fill(_apexes, None);
        foreach ((int from, int to) in edges)
        {
            _front.Add(from, to);
        }
    }

    /// <summary>Fills all gaps.</summary>
    /// <returns>Three indices of vertices for each facet.</returns>
    /// <exception cref="BadInputException">A gap can't be filled: borders cross.</exception>
    public int[] Fill()
    {
        while (_front.TryDequeue(out int from, out int to))
        {
            int apex = FindApex(from, to);
            _front.Remove(from, to);
            Cover(from, apex);
            Cover(apex, to);
            _corners.AddRange([from, to, apex]);
        }

        return [.. _corners];
    }

    /// <summary>Goes on behind a new side of a facet, or ends where that side is a border.</summary>
    private void Cover(int from, int to)
    {
        if (_front.Has(to, from))
        {
            _front.Remove(to, from);
        }
        else
        {
            _front.Add(from, to);
        }
    }

    /// <summary>The third corner of the facet on the left of an edge.</summary>
    private int FindApex(int from, int to)
    {
        int beside = BestBeside(from, to);
        double reachBeside = Math.Max(_reaches[from], _reaches[to]);
        if (beside != None && _geometry.ReachOf(from, to, beside) <= MaxGrowth * reachBeside && IsFree(from, to, beside))
        {
            Note(beside, reachBeside); // not its own reach: it would grow from facet to facet
            return beside;
        }

        // All that lies in the circle through the edge and the apex was looked at, so that the radius makes no difference.
        for (double radius = _geometry.LengthOf(from, to); radius < 4.0 * WidestSearch; radius *= 2.0)
        {
            int apex = BestWithin(from, to, radius, radius >= WidestSearch ? double.PositiveInfinity : radius);
            if (apex != None)
            {
                Note(apex, _geometry.ReachOf(from, to, apex));
                return apex;
            }
        }

        throw _geometry.Crossing(from);

        void Note(int apex, double reach)
        {
            (_apexes[from], _apexes[to]) = (apex, apex);
            (_reaches[from], _reaches[to]) = (reach, reach);
        }
    }

    /// <summary>
    /// The best of the vertices beside the facets that the edge's ends had last, and along the front from there; most often the facet
    /// beside has the same apex.
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

        Try(_front.After(to));
        Try(_front.Before(from));
        for (int before = None; before != best;)
        {
            before = best;
            Try(_front.After(before));
            Try(_front.Before(before));
        }

        return best;

        void Try(int vertex)
        {
            if (vertex == None || vertex == from || vertex == to || _geometry.Orient(from, to, vertex) <= 0)
            {
                return;
            }

            double cotangent = _geometry.Cotangent(from, to, vertex);
            if (cotangent < bestCotangent && _front.Has(vertex))
            {
                (best, bestCotangent) = (vertex, cotangent);
            }
        }
    }

    /// <summary>The best apex, if its circle reaches so far at most.</summary>
    private int BestWithin(int from, int to, double radius, double reach)
    {
        Vector3D middle = _geometry.MiddleOf(from, to);
        _front.Find(middle, new Vector3D(radius, radius, radius), [_geometry.NormalOf(from, to)], _near);
        _candidates.Clear();
        _stamp++;
        _seen[from] = _seen[to] = _stamp;
        foreach (int edge in _near)
        {
            Consider(_front.Edges[edge].From);
            Consider(_front.Edges[edge].To);
        }

        while (_candidates.Count > 0)
        {
            int best = 0;
            double bestCotangent = double.PositiveInfinity;
            for (int i = 0; i < _candidates.Count; i++)
            {
                double cotangent = _geometry.Cotangent(from, to, _candidates[i]);
                if (cotangent < bestCotangent || (cotangent == bestCotangent && _candidates[i] < _candidates[best]))
                {
                    (best, bestCotangent) = (i, cotangent);
                }
            }

            int apex = _candidates[best];
            if (_geometry.ReachOf(from, to, apex) > reach)
            {
                return None;
            }

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
                if ((_geometry.PlaceOf(vertex) - middle).LengthSquared <= reach * reach && _geometry.Orient(from, to, vertex) > 0)
                {
                    _candidates.Add(vertex);
                }
            }
        }
    }

    /// <summary>Whether nothing of the front lies in a facet or crosses it.</summary>
    private bool IsFree(int a, int b, int c)
    {
        (Vector3D Low, Vector3D High) box = _geometry.BoxOf(a, b, c);
        ReadOnlySpan<Vector3D> sides = [_geometry.NormalOf(a, b), _geometry.NormalOf(b, c), _geometry.NormalOf(c, a)];
        _front.Find(0.5 * (box.Low + box.High), 0.5 * (box.High - box.Low), sides, _crossing);
        foreach (int edge in _crossing)
        {
            (int from, int to) = _front.Edges[edge];
            if (_geometry.MayMeet(from, to, box) && (_geometry.Holds(a, b, c, from) || _geometry.Holds(a, b, c, to)
                || _geometry.Cross(from, to, b, c) || _geometry.Cross(from, to, c, a)))
            {
                return false;
            }
        }

        return true;
    }
}
