using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Core.Surface.Sources;

/// <summary>The edges between facets and the gap that is still to be filled; each has the gap on its left.</summary>
/// <param name="geometry">Where the vertices lie.</param>
internal sealed class FrontEdges(SeamGeometry geometry)
{
    private readonly FrontIndex _index = new();
    private readonly List<(int From, int To)> _edges = [];
    private readonly Dictionary<(int From, int To), int> _numbers = [];
    private readonly Queue<int> _queue = [];
    private readonly int[] _after = new int[geometry.Count];
    private readonly int[] _before = new int[geometry.Count];

    /// <summary>All edges that ever were on the front, by number.</summary>
    public IReadOnlyList<(int From, int To)> Edges => _edges;

    /// <summary>Whether an edge is on the front.</summary>
    public bool Has(int from, int to) => _numbers.ContainsKey((from, to));

    /// <summary>Whether a vertex is on the front; false for some that have several edges there.</summary>
    public bool Has(int vertex) => Has(vertex, _after[vertex]) || Has(_before[vertex], vertex);

    /// <summary>The vertex that followed a vertex last.</summary>
    public int After(int vertex) => _after[vertex];

    /// <summary>The vertex before a vertex, as it was last.</summary>
    public int Before(int vertex) => _before[vertex];

    /// <summary>Adds an edge.</summary>
    /// <exception cref="BadInputException">It is there already: borders cross.</exception>
    public void Add(int from, int to)
    {
        if (!_numbers.TryAdd((from, to), _edges.Count))
        {
            throw geometry.Crossing(from);
        }

        _index.Add(_edges.Count, geometry.MiddleOf(from, to), geometry.LengthOf(from, to));
        (_after[from], _before[to]) = (to, from);
        _queue.Enqueue(_edges.Count);
        _edges.Add((from, to));
    }

    /// <summary>Removes an edge.</summary>
    public void Remove(int from, int to)
    {
        _numbers.Remove((from, to), out int edge);
        _index.Remove(edge, geometry.MiddleOf(from, to), geometry.LengthOf(from, to));
    }

    /// <summary>The edge that has been on the front for the longest time; false if there is none.</summary>
    public bool TryDequeue(out int from, out int to)
    {
        while (_queue.TryDequeue(out int edge))
        {
            (from, to) = _edges[edge];
            if (_numbers.TryGetValue((from, to), out int current) && current == edge)
            {
                return true;
            }
        }

        (from, to) = (0, 0);
        return false;
    }

    /// <summary>Finds all edges with a point in a box, and some others.</summary>
    /// <param name="centre">Its middle, m.</param>
    /// <param name="reach">Half of its extent along each axis, m.</param>
    /// <param name="edges">Receives their numbers, in no order.</param>
    public void Find(Vector3D centre, Vector3D reach, List<int> edges) => _index.Find(centre, reach, edges);
}
