using System.Runtime.InteropServices;
using Msisf.Core.Numerics;

namespace Msisf.Core.Mesh.Nesting;

/// <summary>Finds edges near a place, whatever their lengths: a tree of cubes, each with the edges that are about as long as it is wide.</summary>
internal sealed class FrontIndex
{
    /// <summary>Base-2 logarithm of the width, m, of the cube that holds the Moon.</summary>
    private const int TopLevel = 23;

    private readonly Dictionary<Cube, Content> _cubes = [];

    /// <summary>Adds an edge.</summary>
    /// <param name="edge">Its number.</param>
    /// <param name="middle">Its middle, m.</param>
    /// <param name="length">Its length, m.</param>
    public void Add(int edge, Vector3D middle, double length)
    {
        Cube cube = Cube.Around(middle, length);
        Content own = At(cube);
        own.Edges.Add(edge);
        for (; cube.Level < TopLevel; cube = cube.Parent)
        {
            At(cube.Parent).Below++;
        }
    }

    /// <summary>Removes an edge that was added with the same numbers.</summary>
    public void Remove(int edge, Vector3D middle, double length)
    {
        Cube cube = Cube.Around(middle, length);
        _cubes[cube].Edges.Remove(edge);
        for (; cube.Level < TopLevel; cube = cube.Parent)
        {
            _cubes[cube.Parent].Below--;
        }
    }

    /// <summary>Finds all edges with a point in a ball, and some others.</summary>
    /// <param name="centre">m.</param>
    /// <param name="radius">m.</param>
    /// <param name="edges">Receives their numbers, in no order.</param>
    public void Find(Vector3D centre, double radius, List<int> edges)
    {
        edges.Clear();
        for (int x = -1; x <= 0; x++)
        {
            for (int y = -1; y <= 0; y++)
            {
                for (int z = -1; z <= 0; z++)
                {
                    Visit(new Cube(TopLevel, x, y, z), centre, radius, edges);
                }
            }
        }
    }

    private void Visit(Cube cube, Vector3D centre, double radius, List<int> edges)
    {
        if (!_cubes.TryGetValue(cube, out Content? content) || !cube.IsNear(centre, radius))
        {
            return;
        }

        edges.AddRange(content.Edges);
        for (int child = 0; content.Below > 0 && child < 8; child++)
        {
            Visit(
                new Cube(cube.Level - 1, (2 * cube.X) + (child & 1), (2 * cube.Y) + (child >> 1 & 1), (2 * cube.Z) + (child >> 2)), centre,
                radius, edges);
        }
    }

    private Content At(Cube cube)
    {
        ref Content? content = ref CollectionsMarshal.GetValueRefOrAddDefault(_cubes, cube, out _);
        return content ??= new Content();
    }

    private readonly record struct Cube(int Level, int X, int Y, int Z)
    {
        public Cube Parent => new(Level + 1, X >> 1, Y >> 1, Z >> 1);

        public static Cube Around(Vector3D middle, double length)
        {
            int level = Math.Clamp(Math.ILogB(Math.Max(length, 1e-3)) + 1, -10, TopLevel);
            return new Cube(level, Part(middle.X, level), Part(middle.Y, level), Part(middle.Z, level));
        }

        /// <summary>Whether an edge whose middle is in the cube, and that is no longer than the cube is wide, may reach a ball.</summary>
        public bool IsNear(Vector3D centre, double radius)
        {
            double width = Math.ScaleB(1.0, Level);
            double reach = radius + (0.5 * width);
            return Distance(centre.X, X * width, width) <= reach && Distance(centre.Y, Y * width, width) <= reach
                && Distance(centre.Z, Z * width, width) <= reach;
        }

        private static int Part(double value, int level) => (int)Math.Floor(Math.ScaleB(value, -level));

        private static double Distance(double value, double start, double width) =>
            Math.Max(0.0, Math.Max(start - value, value - (start + width)));
    }

    private sealed class Content
    {
        public HashSet<int> Edges { get; } = [];

        /// <summary>Number of edges in the smaller cubes within this one.</summary>
        public int Below { get; set; }
    }
}
