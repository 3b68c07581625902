using System.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>A block of cells in the tree that a ray walks down. Row r is the cell line r - 1: row 0 is the fan of the north pole.</summary>
/// <param name="Row">Northernmost row.</param>
/// <param name="Column">Westernmost cell.</param>
/// <param name="Rows">At least 1.</param>
/// <param name="Columns">At least 1.</param>
internal readonly record struct CellRectangle(int Row, int Column, int Rows, int Columns)
{
    /// <summary>The longer side.</summary>
    public int Size => Math.Max(Rows, Columns);

    /// <summary>
    /// Western and eastern part. The cut is at a power of two, so that a block of at most 2^k cells a side never lies across a
    /// multiple of 2^k.
    /// </summary>
    public (CellRectangle West, CellRectangle East) CutAlongMeridian()
    {
        int west = CutOf(Columns);
        return (this with { Columns = west }, this with { Column = Column + west, Columns = Columns - west });
    }

    /// <summary>Northern and southern part, cut as by <see cref="CutAlongMeridian"/>.</summary>
    public (CellRectangle North, CellRectangle South) CutAlongParallel()
    {
        int north = CutOf(Rows);
        return (this with { Rows = north }, this with { Row = Row + north, Rows = Rows - north });
    }

    /// <summary>The largest power of two below a number from 2 on.</summary>
    private static int CutOf(int cells) => 1 << BitOperations.Log2((uint)(cells - 1));
}
