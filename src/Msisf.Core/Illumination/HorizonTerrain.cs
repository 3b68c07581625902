using System.Runtime.CompilerServices;
using Msisf.Core.Surface;

namespace Msisf.Core.Illumination;

/// <summary>
/// The terrain as searches for horizons see it: bounds of its nodes, and the vertices of the blocks that they have come to. Safe for
/// several threads.
/// </summary>
/// <param name="surface">The surface.</param>
internal sealed class HorizonTerrain(SurfaceModel surface)
{
    /// <summary>Blocks that are kept, 32 kB each: all are dropped when there are more.</summary>
    private const int MaxBlocks = 16_384;

    private readonly NodeTable[] _tables = [.. surface.Parts.Select(part => new NodeTable(part))];
    private readonly TerrainNode[] _seams = [.. surface.Seams.Blocks.Select(block => block.Node)];
    private readonly Lock _gate = new();
    private Dictionary<(int Part, int Row, int Column), (BlockVertices Vertices, Vector3D Origin)> _blocks = [];

    /// <summary>The surface.</summary>
    public SurfaceModel Surface => surface;

    /// <summary>Bounds of the blocks of the seams.</summary>
    public IReadOnlyList<TerrainNode> Seams => _seams;

    /// <summary>Bounds of a node of a model.</summary>
    public ref readonly TerrainNode NodeOf(int part, NodePlace node) => ref _tables[part].Of(node);

    /// <summary>The vertices of a block, relative to an origin, m, body-fixed.</summary>
    public (BlockVertices Vertices, Vector3D Origin) BlockAt(int part, int row, int column)
    {
        lock (_gate)
        {
            if (_blocks.TryGetValue((part, row, column), out (BlockVertices, Vector3D) known))
            {
                return known;
            }
        }

        Patch patch = surface.Patches[part];
        CellBlock block = new(row, column) { Part = part };
        TerrainNode node = patch.NodeOf(block.Node, patch.BoundsOf(block.Node));
        Vector3D origin = node.MaxRadius * node.Cap.Centre;
        BlockVertices vertices = new();
        vertices.Load(surface, block, origin);
        lock (_gate)
        {
            if (_blocks.Count >= MaxBlocks)
            {
                _blocks = []; // the other threads keep what they hold
            }

            _blocks[(part, row, column)] = (vertices, origin);
        }

        return (vertices, origin);
    }

    /// <summary>The nodes of a model that were asked for; threads that ask for the same one at once make it alike.</summary>
    private sealed class NodeTable
    {
        private readonly GridPatch _part;
        private readonly StrongBox<TerrainNode>?[]?[][] _rows;

        public NodeTable(GridPatch part)
        {
            _part = part;
            _rows = [.. Enumerable.Range(0, part.Layout.Levels)
                .Select(level => new StrongBox<TerrainNode>?[]?[part.Layout.Rows(level)])];
        }

        public ref readonly TerrainNode Of(NodePlace node)
        {
            StrongBox<TerrainNode>?[] row = Volatile.Read(ref _rows[node.Level][node.Row]) ?? NewRow(node);
            StrongBox<TerrainNode>? known = Volatile.Read(ref row[node.Column]);
            if (known is null)
            {
                known = new StrongBox<TerrainNode>(_part.NodeOf(node, _part.BoundsOf(node)));
                Volatile.Write(ref row[node.Column], known);
            }

            return ref known.Value;
        }

        private StrongBox<TerrainNode>?[] NewRow(NodePlace node)
        {
            StrongBox<TerrainNode>?[] made = new StrongBox<TerrainNode>?[_part.Layout.Columns(node.Level)];
            return Interlocked.CompareExchange(ref _rows[node.Level][node.Row], made, null) ?? made;
        }
    }
}
