using Msisf.Core.Surface;
using Msisf.Core.Tiles;

namespace Msisf.TestSupport;

/// <summary>Collects meshes and judges, by lattice coordinates alone, whether together they close a surface.</summary>
internal sealed class ClosedSurface
{
    private readonly Dictionary<LatticePoint, uint> _vertices = [];
    private readonly List<ulong> _edges = [];

    /// <summary>Triangles whose front looks towards the Moon's centre.</summary>
    public int InwardFaces { get; private set; }

    /// <summary>V - E + F: 2 for a sphere.</summary>
    public int EulerCharacteristic => _vertices.Count - (_edges.Count / 2) + (_edges.Count / 3);

    public int Faces => _edges.Count / 3;

    public int Vertices => _vertices.Count;

    public void Add(TileMesh mesh)
    {
        LatticePoint[] points = [.. Enumerable.Range(0, mesh.VertexCount).Select(mesh.Vertex)];
        uint[] numbers = [.. points.Select(NumberOf)];
        for (int i = 0; i < mesh.Faces.Length; i += 3)
        {
            (int a, int b, int c) = (mesh.Faces[i], mesh.Faces[i + 1], mesh.Faces[i + 2]);
            InwardFaces += LooksOutward(points[a], points[b], points[c]) ? 0 : 1;
            _edges.Add(Edge(numbers[a], numbers[b]));
            _edges.Add(Edge(numbers[b], numbers[c]));
            _edges.Add(Edge(numbers[c], numbers[a]));
        }
    }

    /// <summary>Edges that are not run through once in each direction.</summary>
    public int CountOpenEdges()
    {
        ulong[] forward = [.. _edges];
        ulong[] backward = [.. _edges.Select(edge => Edge((uint)edge, (uint)(edge >> 32)))];
        Array.Sort(forward);
        Array.Sort(backward);
        int open = 0;
        for (int i = 0; i < forward.Length; i++)
        {
            bool isDouble = i > 0 && forward[i] == forward[i - 1];
            open += isDouble || forward[i] != backward[i] ? 1 : 0;
        }

        return open;
    }

    private static ulong Edge(uint from, uint to) => ((ulong)from << 32) | to;

    private static bool LooksOutward(LatticePoint a, LatticePoint b, LatticePoint c)
    {
        (long ux, long uy, long uz) = (b.X - a.X, b.Y - a.Y, b.Z - a.Z);
        (long vx, long vy, long vz) = (c.X - a.X, c.Y - a.Y, c.Z - a.Z);
        Int128 x = (Int128)((uy * vz) - (uz * vy)) * a.X;
        Int128 y = (Int128)((uz * vx) - (ux * vz)) * a.Y;
        Int128 z = (Int128)((ux * vy) - (uy * vx)) * a.Z;
        return x + y + z > 0;
    }

    private uint NumberOf(LatticePoint point)
    {
        if (!_vertices.TryGetValue(point, out uint number))
        {
            number = (uint)_vertices.Count;
            _vertices.Add(point, number);
        }

        return number;
    }
}
