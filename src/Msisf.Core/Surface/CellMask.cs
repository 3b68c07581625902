using System.Numerics;

namespace Msisf.Core.Surface;

/// <summary>
/// Which cells of a mesh belong to the surface, block by block. Cells are removed first, by one thread; after <see cref="Seal"/> it is
/// immutable.
/// </summary>
internal sealed class CellMask
{
    private const uint AllCells = uint.MaxValue;

    private readonly CellRange _all;
    private readonly int _columns;
    private readonly BlockState[] _states;
    private readonly Dictionary<int, uint[]> _rows = [];
    private readonly Dictionary<int, (int First, int Count)> _piecesOf = [];
    private readonly List<CellRange> _pieces = [];

    /// <summary>Makes a mask that keeps all cells.</summary>
    public CellMask(FacetMesh mesh)
    {
        _all = mesh.Cells;
        _columns = CellBlock.ColumnsOf(mesh);
        BlockRows = CellBlock.RowsOf(mesh);
        _states = new BlockState[BlockRows * _columns];
    }

    /// <summary>A mask that keeps no cell.</summary>
    public static CellMask NoneOf(FacetMesh mesh)
    {
        CellMask mask = new(mesh);
        Array.Fill(mask._states, BlockState.Empty);
        mask.Seal();
        return mask;
    }

    /// <summary>What of a block is kept.</summary>
    public enum BlockState : byte
    {
        /// <summary>All cells.</summary>
        Whole,

        /// <summary>No cell.</summary>
        Empty,

        /// <summary>Some cells.</summary>
        Partial,
    }

    public int BlockRows { get; }

    public int BlockColumns => _columns;

    /// <summary>Rectangles that together are the kept cells of all partial blocks; complete after <see cref="Seal"/>.</summary>
    public IReadOnlyList<CellRange> Pieces => _pieces;

    /// <summary>Whether any cell is kept; known after <see cref="Seal"/>.</summary>
    public bool IsAny { get; private set; } = true;

    /// <summary>What of a block is kept.</summary>
    public BlockState StateOf(int row, int column) => _states[(row * _columns) + column];

    /// <summary>The pieces of a partial block, as indices in <see cref="Pieces"/> counted from 1.</summary>
    public (int First, int Count) PiecesOf(int row, int column) => _piecesOf[(row * _columns) + column];

    /// <summary>Whether a cell of the mesh is kept.</summary>
    public bool Has(int line, int sample)
    {
        int block = BlockOf(line, sample, out int row, out int bit);
        return _states[block] switch
        {
            BlockState.Whole => true,
            BlockState.Empty => false,
            _ => (_rows[block][row] >> bit & 1) != 0,
        };
    }

    /// <summary>Whether any cell of a rectangle is kept; the part outside the mesh has none.</summary>
    public bool HasAny(CellRange cells) => !AreAll(cells, isKept: false);

    /// <summary>Whether the mesh has all cells of a rectangle and keeps them.</summary>
    public bool HasAll(CellRange cells) =>
        cells.FirstLine >= _all.FirstLine && cells.EndLine <= _all.EndLine && cells.FirstSample >= _all.FirstSample
        && cells.EndSample <= _all.EndSample && AreAll(cells, isKept: true);

    public void RemoveBlock(int row, int column)
    {
        int block = (row * _columns) + column;
        _states[block] = BlockState.Empty;
        _rows.Remove(block);
    }

    /// <summary>Removes a cell of the mesh.</summary>
    public void Remove(int line, int sample)
    {
        int block = BlockOf(line, sample, out int row, out int bit);
        if (_states[block] == BlockState.Empty)
        {
            return;
        }

        if (_states[block] == BlockState.Whole)
        {
            _states[block] = BlockState.Partial;
            _rows[block] = new uint[CellBlock.Size];
            Array.Fill(_rows[block], AllCells);
        }

        _rows[block][row] &= ~(1u << bit);
    }

    /// <summary>Ends the removing: finds the pieces of partial blocks.</summary>
    public void Seal()
    {
        foreach (int block in _rows.Keys.Order().ToArray())
        {
            int firstLine = _all.FirstLine + (block / _columns * CellBlock.Size);
            int firstSample = _all.FirstSample + (block % _columns * CellBlock.Size);
            uint[] rows = _rows[block];
            uint inMesh = AllCells >> (CellBlock.Size - Math.Min(CellBlock.Size, _all.EndSample - firstSample));
            int lines = Math.Min(CellBlock.Size, _all.EndLine - firstLine);
            int first = _pieces.Count;
            AddPieces(rows.AsSpan(0, lines), inMesh, firstLine, firstSample);
            _piecesOf[block] = (first + 1, _pieces.Count - first);
            if (_pieces.Count == first)
            {
                _states[block] = BlockState.Empty;
                _rows.Remove(block);
            }
        }

        IsAny = Array.Exists(_states, state => state != BlockState.Empty);
    }

    /// <summary>Divides the kept cells of a block into rectangles: runs of a row, as far down as they repeat.</summary>
    private void AddPieces(ReadOnlySpan<uint> rows, uint inMesh, int firstLine, int firstSample)
    {
        Dictionary<(int First, int End), int> open = [];
        for (int row = 0; row < rows.Length; row++)
        {
            Dictionary<(int First, int End), int> next = [];
            for (uint bits = rows[row] & inMesh; bits != 0;)
            {
                int first = BitOperations.TrailingZeroCount(bits);
                int end = first + BitOperations.TrailingZeroCount(~((ulong)bits >> first));
                bits = end == CellBlock.Size ? 0 : bits & (AllCells << end);
                if (open.TryGetValue((first, end), out int piece))
                {
                    _pieces[piece] = _pieces[piece] with { EndLine = firstLine + row + 1 };
                }
                else
                {
                    piece = _pieces.Count;
                    _pieces.Add(new CellRange(firstLine + row, firstLine + row + 1, firstSample + first, firstSample + end));
                }

                next[(first, end)] = piece;
            }

            open = next;
        }
    }

    private bool AreAll(CellRange cells, bool isKept)
    {
        int firstLine = Math.Max(cells.FirstLine, _all.FirstLine) - _all.FirstLine;
        int endLine = Math.Min(cells.EndLine, _all.EndLine) - _all.FirstLine;
        int firstSample = Math.Max(cells.FirstSample, _all.FirstSample) - _all.FirstSample;
        int endSample = Math.Min(cells.EndSample, _all.EndSample) - _all.FirstSample;
        if (firstLine >= endLine || firstSample >= endSample)
        {
            return true;
        }

        for (int row = firstLine / CellBlock.Size; row <= (endLine - 1) / CellBlock.Size; row++)
        {
            for (int column = firstSample / CellBlock.Size; column <= (endSample - 1) / CellBlock.Size; column++)
            {
                BlockState state = StateOf(row, column);
                if (state != (isKept ? BlockState.Whole : BlockState.Empty)
                    && (state != BlockState.Partial || !AreAllOf(row, column, (firstLine, endLine, firstSample, endSample), isKept)))
                {
                    return false;
                }
            }
        }

        return true;
    }

    private bool AreAllOf(
        int row, int column, (int FirstLine, int EndLine, int FirstSample, int EndSample) cells, bool isKept)
    {
        uint[] rows = _rows[(row * _columns) + column];
        int first = Math.Max(cells.FirstSample - (column * CellBlock.Size), 0);
        int end = Math.Min(cells.EndSample - (column * CellBlock.Size), CellBlock.Size);
        uint wanted = (AllCells >> (CellBlock.Size - end)) & (AllCells << first);
        int top = Math.Max(cells.FirstLine - (row * CellBlock.Size), 0);
        int bottom = Math.Min(cells.EndLine - (row * CellBlock.Size), CellBlock.Size);
        for (int line = top; line < bottom; line++)
        {
            if ((rows[line] & wanted) != (isKept ? wanted : 0))
            {
                return false;
            }
        }

        return true;
    }

    private int BlockOf(int line, int sample, out int row, out int bit)
    {
        int down = line - _all.FirstLine;
        int right = sample - _all.FirstSample;
        row = down % CellBlock.Size;
        bit = right % CellBlock.Size;
        return (down / CellBlock.Size * _columns) + (right / CellBlock.Size);
    }
}
