namespace Msisf.Core.Lod;

/// <summary>
/// How the samples of a level are cut into blocks, which are computed, kept and stored as a whole; those at the southern and eastern
/// border may be smaller. <c>default</c> is no layout.
/// </summary>
/// <param name="PixelsPerDegree">Samples a degree.</param>
public readonly record struct LodLayout(int PixelsPerDegree)
{
    /// <summary>Binary logarithm of the side of a block: 64 x 64 floats fill four memory pages.</summary>
    public const int SideShift = 6;

    /// <summary>Number of lines, and of samples of a line, of a block.</summary>
    public const int Side = 1 << SideShift;

    /// <summary>Samples of a block.</summary>
    public const int BlockSamples = Side * Side;

    /// <summary>Lines of the whole Moon.</summary>
    public int Lines => 180 * PixelsPerDegree;

    /// <summary>Samples of a line.</summary>
    public int Samples => 360 * PixelsPerDegree;

    /// <summary>Blocks from north to south.</summary>
    public int BlockRows => (Lines + Side - 1) >> SideShift;

    /// <summary>Blocks from west to east.</summary>
    public int BlockColumns => (Samples + Side - 1) >> SideShift;

    /// <summary>All blocks, row by row from the north.</summary>
    public int Blocks => BlockRows * BlockColumns;

    /// <summary>Lines of the blocks of a row.</summary>
    public int LinesOf(int blockRow) => Math.Min(Side, Lines - (blockRow << SideShift));

    /// <summary>Samples of the blocks of a column.</summary>
    public int SamplesOf(int blockColumn) => Math.Min(Side, Samples - (blockColumn << SideShift));

    /// <summary>Refuses a block of samples that is not on the Moon.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public void CheckRange(int firstLine, int lines, int firstSample, int samples)
    {
        if (firstLine < 0 || lines < 1 || lines > Lines - firstLine || (uint)firstSample >= (uint)Samples
            || (uint)(samples - 1) >= (uint)Samples)
        {
            throw new ArgumentOutOfRangeException(
                nameof(firstLine),
                $"No block of {Lines} x {Samples} samples: {lines} lines from {firstLine}, {samples} samples from {firstSample}.");
        }
    }
}
