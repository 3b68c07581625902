using Msisf.Core.Terrain;

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
    /// <param name="sides">Normals, m^2, of planes through the Moon's centre: edges wholly behind one need not be found.</param>
    /// <param name="edges">Receives their numbers, in no order.</param>
    public void Find(Vector3D centre, Vector3D reach, ReadOnlySpan<Vector3D> sides, List<int> edges) =>
        _index.Find(centre, reach, sides, edges);
}

/// <summary>
/// Finds edges near a place, whatever their lengths: a tree of cubes, each with the edges that are about as long as it is wide.
/// </summary>
internal sealed class FrontIndex
{
    /// <summary>m: half the width of the cube that holds the Moon.</summary>
    private const double Half = 1 << 22;

    /// <summary>m: half the width of the smallest cubes.</summary>
    private const double Smallest = 1.0 / 1024.0;

    /// <summary>m^3: what is so far behind a plane is so for sure; ten times what rounding makes of a normal.</summary>
    private const double Behind = 1e-8 * MoonConstants.ReferenceRadius * MoonConstants.ReferenceRadius;

    private readonly Cube _top = new();

    /// <summary>Adds an edge.</summary>
    /// <param name="middle">Its middle, m.</param>
    /// <param name="length">Its length, m.</param>
    public void Add(int edge, Vector3D middle, double length) => Change(middle, length, 1).Edges.Add(edge);

    /// <summary>Removes an edge that was added with the same numbers.</summary>
    public void Remove(int edge, Vector3D middle, double length) => Change(middle, length, -1).Edges.Remove(edge);

    /// <summary>Finds all edges with a point in a box, and some others.</summary>
    /// <param name="centre">Its middle, m.</param>
    /// <param name="reach">Half of its extent along each axis, m.</param>
    /// <param name="sides">Normals, m^2, of planes through the Moon's centre: edges wholly behind one need not be found.</param>
    /// <param name="edges">Receives their numbers, in no order.</param>
    public void Find(Vector3D centre, Vector3D reach, ReadOnlySpan<Vector3D> sides, List<int> edges)
    {
        edges.Clear();
        Visit(_top, default, Half, centre, reach, sides, edges);
    }

    private static void Visit(
        Cube cube, Vector3D middle, double half, Vector3D centre, Vector3D reach, ReadOnlySpan<Vector3D> sides, List<int> edges)
    {
        // An edge is no longer than its cube is wide, and its middle is in the cube; some more, as edges lie below the sphere.
        double around = 2.1 * half;
        if (cube.Count == 0 || Math.Abs(centre.X - middle.X) > reach.X + around || Math.Abs(centre.Y - middle.Y) > reach.Y + around
            || Math.Abs(centre.Z - middle.Z) > reach.Z + around)
        {
            return;
        }

        foreach (Vector3D side in sides)
        {
            double extent = around * (Math.Abs(side.X) + Math.Abs(side.Y) + Math.Abs(side.Z));
            if (Vector3D.Dot(side, middle) + extent < -Behind)
            {
                return;
            }
        }

        edges.AddRange(cube.Edges);
        for (int child = 0; child < cube.Children.Length; child++)
        {
            if (cube.Children[child] is { } next)
            {
                Visit(next, MiddleOf(middle, 0.5 * half, child), 0.5 * half, centre, reach, sides, edges);
            }
        }
    }

    private static Vector3D MiddleOf(Vector3D parent, double half, int child) => new(
        parent.X + ((child & 1) != 0 ? half : -half), parent.Y + ((child & 2) != 0 ? half : -half),
        parent.Z + ((child & 4) != 0 ? half : -half));

    /// <summary>Counts an edge in all cubes around it, and returns the smallest of them.</summary>
    private Cube Change(Vector3D middle, double length, int by)
    {
        Cube cube = _top;
        Vector3D place = default;
        cube.Count += by;
        for (double half = 0.5 * Half; 2.0 * half >= length && half >= Smallest; half *= 0.5)
        {
            int child = (middle.X >= place.X ? 1 : 0) | (middle.Y >= place.Y ? 2 : 0) | (middle.Z >= place.Z ? 4 : 0);
            place = MiddleOf(place, half, child);
            if (cube.Children.Length == 0)
            {
                cube.Children = new Cube?[8];
            }

            cube = cube.Children[child] ??= new Cube();
            cube.Count += by;
        }

        return cube;
    }

    private sealed class Cube
    {
        public Cube?[] Children { get; set; } = [];

        public List<int> Edges { get; } = [];

        /// <summary>Number of edges in this cube and those within it.</summary>
        public int Count { get; set; }
    }
}
