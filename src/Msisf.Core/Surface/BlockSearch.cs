using Msisf.Core.Parallel;

namespace Msisf.Core.Surface;

/// <summary>What a search looks for among the blocks of a surface. A structure, so that it is compiled into the search.</summary>
/// <typeparam name="TFound">What is noted of each block that is found.</typeparam>
internal interface IBlockTester<TFound>
{
    /// <summary>Whether a node may have such a block; nothing is read.</summary>
    bool MayHold(Patch patch, NodePlace node);

    /// <summary>Whether a block is one; its bounds are read if they were not yet.</summary>
    bool TryFind(Patch patch, CellBlock block, out TFound found);

    /// <summary>The block that was found.</summary>
    CellBlock BlockOf(TFound found);

    /// <summary>The same for a piece of the block that was found.</summary>
    TFound WithBlock(TFound found, CellBlock piece);
}

/// <summary>
/// Finds blocks of a surface: walks down to groups of blocks without reading, then looks at the blocks of the groups with several threads.
/// One object serves many searches, one at a time, and keeps its memory.
/// </summary>
/// <typeparam name="TFound">What is noted of each block that is found.</typeparam>
internal sealed class BlockSearch<TFound>(SurfaceModel surface)
    where TFound : struct
{
    private readonly List<(int Part, NodePlace Node)> _groups = [];
    private readonly List<TFound> _result = [];
    private TFound[] _found = [];
    private int[] _counts = [];

    /// <summary>Number of groups of blocks that the last search looked into.</summary>
    public int Groups => _groups.Count;

    /// <summary>Finds the blocks, always in the same order; of one that finer models have left in pieces, these.</summary>
    /// <param name="tester">What is looked for.</param>
    /// <returns>Valid until the next search.</returns>
    public List<TFound> Find<TTester>(TTester tester, int threads, CancellationToken cancellation)
        where TTester : struct, IBlockTester<TFound>
    {
        _groups.Clear();
        for (int part = 0; part < surface.Patches.Length; part++)
        {
            Patch patch = surface.Patches[part];
            if (!patch.IsLeftOut)
            {
                GroupCollector<TTester> collector = new(tester, patch, part, _groups);
                NodeWalk.All(patch.Layout, ref collector);
            }
        }

        if (_counts.Length < _groups.Count)
        {
            _counts = new int[2 * _groups.Count];
            _found = new TFound[2 * _groups.Count * SquareLayout.GroupBlocks];
        }

        WorkerTeam.Run(
            threads,
            _groups.Count,
            (_, group) =>
            {
                (int part, NodePlace node) = _groups[group];
                BlockCollector<TTester> collector = new(tester, surface.Patches[part], part, _found, group * SquareLayout.GroupBlocks);
                NodeWalk.From(surface.Patches[part].Layout, node, ref collector);
                _counts[group] = collector.Count;
            },
            cancellation);
        _result.Clear();
        for (int group = 0; group < _groups.Count; group++)
        {
            foreach (TFound found in _found.AsSpan(group * SquareLayout.GroupBlocks, _counts[group]))
            {
                CellBlock block = tester.BlockOf(found);
                (int first, int count) = surface.Patches[block.Part].PiecesOf(block);
                for (int piece = first; piece < first + count; piece++)
                {
                    _result.Add(tester.WithBlock(found, block with { Piece = piece }));
                }
            }
        }

        return _result;
    }

    private struct GroupCollector<TTester>(TTester tester, Patch patch, int part, List<(int Part, NodePlace Node)> groups) : INodeTester
        where TTester : struct, IBlockTester<TFound>
    {
        public readonly Visit Test(NodePlace node)
        {
            if (!tester.MayHold(patch, node))
            {
                return Visit.Skip;
            }

            if (node.Level > SquareLayout.GroupLevel)
            {
                return Visit.Descend;
            }

            groups.Add((part, node));
            return Visit.Skip;
        }
    }

    private struct BlockCollector<TTester>(TTester tester, Patch patch, int part, TFound[] found, int first) : INodeTester
        where TTester : struct, IBlockTester<TFound>
    {
        public int Count { get; private set; }

        public Visit Test(NodePlace node)
        {
            if (node.Level > SquareLayout.CellBlockLevel)
            {
                return Visit.Descend;
            }

            CellBlock block = new(node.Row, node.Column) { Part = part };
            if (patch.Kept?.StateOf(node.Row, node.Column) != CellMask.BlockState.Empty && tester.MayHold(patch, node)
                && tester.TryFind(patch, block, out found[first + Count]))
            {
                Count++;
            }

            return Visit.Skip;
        }
    }
}
