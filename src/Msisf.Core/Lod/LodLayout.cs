using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// How the samples of a level are cut into blocks, which are computed, kept and stored as a whole. Blocks begin at multiples of
/// <see cref="Side"/> lines and samples of the level's grid; those at the borders of its window may be smaller. <c>default</c> is not a
/// layout.
/// </summary>
/// <param name="Window">The part of the grid that the level has.</param>
/// <param name="IsRing">Whether a line goes around the whole Moon, so that its first sample follows the last one.</param>
public readonly record struct LodLayout(GridWindow Window, bool IsRing)
{
    /// <summary>Binary logarithm of the side of a block: 64 x 64 floats fill four memory pages.</summary>
    public const int SideShift = 6;

    /// <summary>Number of lines, and of samples of a line, of a block.</summary>
    public const int Side = 1 << SideShift;

    /// <summary>Samples of a block.</summary>
    public const int BlockSamples = Side * Side;

    /// <summary>The blocks of a whole Moon of latitude and longitude.</summary>
    /// <param name="pixelsPerDegree">Samples a degree.</param>
    public LodLayout(int pixelsPerDegree)
        : this(new GridWindow(0, 180 * pixelsPerDegree, 0, 360 * pixelsPerDegree), IsRing: true)
    {
    }

    /// <summary>The blocks of a model's own grid.</summary>
    public static LodLayout Of(ITerrainGrid grid) =>
        new(grid.Window, grid.Projection is Equirectangular && grid.Window.Samples == grid.Samples);

    /// <summary>The blocks of the level with half the resolution.</summary>
    public LodLayout Halved() => this with { Window = Window.Halved() };

    /// <summary>Blocks from top to bottom.</summary>
    public int BlockRows => ((Window.EndLine + Side - 1) >> SideShift) - FirstRow;

    /// <summary>Blocks from left to right.</summary>
    public int BlockColumns => ((Window.EndSample + Side - 1) >> SideShift) - FirstColumn;

    /// <summary>All blocks, row by row from the top.</summary>
    public int Blocks => BlockRows * BlockColumns;

    private int FirstRow => Window.FirstLine >> SideShift;

    private int FirstColumn => Window.FirstSample >> SideShift;

    /// <summary>The row of blocks, from 0, in which a line is.</summary>
    public int RowOf(int line) => (line >> SideShift) - FirstRow;

    /// <summary>The column of blocks, from 0, in which a sample is.</summary>
    public int ColumnOf(int sample) => (sample >> SideShift) - FirstColumn;

    /// <summary>The samples of a block that are in the window.</summary>
    /// <param name="row">From the top.</param>
    /// <param name="column">From the left.</param>
    public GridWindow SamplesOf(int row, int column)
    {
        int line = (FirstRow + row) << SideShift;
        int sample = (FirstColumn + column) << SideShift;
        return new GridWindow(
            Math.Max(line, Window.FirstLine),
            Math.Min(line + Side, Window.EndLine),
            Math.Max(sample, Window.FirstSample),
            Math.Min(sample + Side, Window.EndSample));
    }

    /// <summary>Index of a sample among the samples of its block.</summary>
    public static int IndexInBlock(int line, int sample) => ((line & (Side - 1)) << SideShift) | (sample & (Side - 1));

    /// <summary>Refuses samples of a line that the level does not have.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It does not.</exception>
    public void CheckRange(int line, int firstSample, int samples)
    {
        int most = IsRing ? Window.Samples : Window.EndSample - firstSample;
        if (line < Window.FirstLine || line >= Window.EndLine || firstSample < Window.FirstSample
            || firstSample >= Window.EndSample || samples < 1 || samples > most)
        {
            throw new ArgumentOutOfRangeException(nameof(line), $"{Window} has no {samples} samples from {firstSample} in line {line}.");
        }
    }
}
