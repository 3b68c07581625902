using System.Buffers.Binary;
using System.Security.Cryptography;

namespace Msisf.Core.Surface.Sources;

/// <summary>The borders of the gaps between models: sets of edges that hang together, with their vertices and hashes.</summary>
internal sealed class SeamBorders
{
    private readonly int[] _borderOf;
    private readonly List<int>[] _vertices;
    private readonly int[] _places;

    /// <summary>Divides the edges of gaps into borders.</summary>
    /// <param name="isDelaunay">Whether the gaps get a constrained Delaunay triangulation; the hashes say so.</param>
    public SeamBorders(SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges, bool isDelaunay)
    {
        UnionFind together = new(vertices.Length);
        bool[] isEnd = new bool[vertices.Length]; // a pole may be a corner of sides without length only
        foreach ((int from, int to) in edges)
        {
            together.Unite(from, to);
            (isEnd[from], isEnd[to]) = (true, true);
        }

        _borderOf = new int[vertices.Length];
        _places = new int[vertices.Length];
        Dictionary<int, int> numbers = [];
        List<List<int>> members = [];
        for (int vertex = 0; vertex < vertices.Length; vertex++)
        {
            if (!isEnd[vertex])
            {
                continue;
            }

            if (!numbers.TryGetValue(together.Of(vertex), out int border))
            {
                numbers[together.Of(vertex)] = border = members.Count;
                members.Add([]);
            }

            (_borderOf[vertex], _places[vertex]) = (border, members[border].Count);
            members[border].Add(vertex);
        }

        _vertices = [.. members];
        Hashes = HashesOf(vertices, edges, isDelaunay ? [(byte)1] : []);
    }

    /// <summary>SHA-256 of each border: of the places of its edges' ends, in their order.</summary>
    public IReadOnlyList<string> Hashes { get; }

    /// <summary>The vertices of a border.</summary>
    public IReadOnlyList<int> VerticesOf(int border) => _vertices[border];

    /// <summary>The border of a vertex.</summary>
    public int BorderOf(int vertex) => _borderOf[vertex];

    /// <summary>Number of a vertex in its border.</summary>
    public int PlaceOf(int vertex) => _places[vertex];

    private string[] HashesOf(SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges, byte[] kind)
    {
        const int Bytes = 6 * sizeof(double);
        IncrementalHash?[] hashes = new IncrementalHash?[_vertices.Length];
        Span<byte> ends = stackalloc byte[Bytes];
        foreach ((int from, int to) in edges)
        {
            Write(vertices[from].Position, ends);
            Write(vertices[to].Position, ends[(Bytes / 2)..]);
            (hashes[_borderOf[from]] ??= IncrementalHash.CreateHash(HashAlgorithmName.SHA256)).AppendData(ends);
        }

        return [.. hashes.Select(hash =>
        {
            using (hash)
            {
                hash!.AppendData(kind);
                return Convert.ToHexStringLower(hash.GetHashAndReset());
            }
        })];
    }

    private static void Write(Vector3D position, Span<byte> bytes)
    {
        BinaryPrimitives.WriteDoubleLittleEndian(bytes, position.X);
        BinaryPrimitives.WriteDoubleLittleEndian(bytes[8..], position.Y);
        BinaryPrimitives.WriteDoubleLittleEndian(bytes[16..], position.Z);
    }
}

/// <summary>Numbers that are put together into groups.</summary>
internal sealed class UnionFind
{
    private readonly int[] _next;

    /// <summary>Begins with each number alone.</summary>
    /// <param name="count">How many numbers, from 0.</param>
    public UnionFind(int count) => _next = [.. Enumerable.Range(0, count)];

    /// <summary>A number of the group of a number, the same for all of the group.</summary>
    public int Of(int number)
    {
        while (_next[number] != number)
        {
            _next[number] = _next[_next[number]];
            number = _next[number];
        }

        return number;
    }

    /// <summary>Puts the groups of two numbers together.</summary>
    public void Unite(int one, int other) => _next[Of(one)] = Of(other);
}
