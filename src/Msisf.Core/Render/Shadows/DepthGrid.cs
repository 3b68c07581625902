using System.Runtime.CompilerServices;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// A grid of bins across the Sun's rays, with the maximum depth of what lies in each bin and, on coarser levels, in squares of 2, 4, 8 ...
/// bins a side.
/// </summary>
internal sealed class DepthGrid
{
    /// <summary>Maximum number of squares along each edge that <see cref="Max(GridRange)"/> reads; limits its cost to 9 values.</summary>
    private const int Window = 3;

    private readonly List<float[]> _levels = [];
    private LightAxis _u;
    private LightAxis _v;

    /// <summary>Number of bins along each edge of the grid.</summary>
    public int Size { get; private set; }

    /// <summary>The bins along u, the columns of the grid.</summary>
    public LightAxis AxisU => _u;

    /// <summary>The bins along v, the rows of the grid.</summary>
    public LightAxis AxisV => _v;

    /// <summary>Lays the grid over a box; the bins at its border extend to infinity. All of them are to be set then.</summary>
    /// <param name="box">The box, m.</param>
    /// <param name="size">Number of bins along each edge of the grid.</param>
    /// <param name="maxSize">Maximum of that number in later frames of the same size.</param>
    public void Lay(LightBox box, int size, int maxSize)
    {
        Size = size;
        (_u, _v) = (new LightAxis(box.MinU, box.MaxU, size), new LightAxis(box.MinV, box.MaxV, size));
        int level = 0;
        for (int edge = maxSize; ; edge = (edge + 1) / 2, level++)
        {
            if (level == _levels.Count)
            {
                _levels.Add([]);
            }

            if (_levels[level].Length < edge * edge)
            {
                _levels[level] = new float[edge * edge];
            }

            if (edge == 1)
            {
                break;
            }
        }
    }

    /// <summary>Maximum depth of each bin, m, row by row; below any real depth if empty. To be set before <see cref="Finish"/>.</summary>
    public float[] Bins => _levels[0];

    /// <summary>Computes the coarser levels from <see cref="Bins"/>.</summary>
    public void Finish()
    {
        int edge = Size;
        for (int level = 1; edge > 1; level++)
        {
            int fineEdge = edge;
            edge = (edge + 1) / 2;
            for (int row = 0; row < edge; row++)
            {
                ReadOnlySpan<float> north = _levels[level - 1].AsSpan(2 * row * fineEdge, fineEdge);
                ReadOnlySpan<float> south = _levels[level - 1].AsSpan(Math.Min((2 * row) + 1, fineEdge - 1) * fineEdge, fineEdge);
                Span<float> line = _levels[level].AsSpan(row * edge, edge);
                for (int column = 0; column < edge; column++)
                {
                    int west = 2 * column;
                    int east = Math.Min(west + 1, fineEdge - 1);
                    line[column] = MathF.Max(MathF.Max(north[west], north[east]), MathF.Max(south[west], south[east]));
                }
            }
        }
    }

    /// <summary>The bins that a box overlaps.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public GridRange BinsOf(in LightBox box) =>
        new(_u.BinOf(box.MinU), _u.BinOf(box.MaxU), _v.BinOf(box.MinV), _v.BinOf(box.MaxV));

    /// <summary>Upper bound of the depth in all bins, m.</summary>
    public float Max() => Max(new GridRange(0, Size - 1, 0, Size - 1));

    /// <summary>
    /// Upper bound of the depth in a range of bins, m; below any real depth if it is empty. It can exceed the maximum, because the squares
    /// that are read may extend beyond the range.
    /// </summary>
    public float Max(GridRange bins)
    {
        int level = 0;
        int edge = Size;
        while (Math.Max(
            (bins.LastColumn >> level) - (bins.FirstColumn >> level), (bins.LastRow >> level) - (bins.FirstRow >> level)) >= Window)
        {
            level++;
            edge = (edge + 1) / 2;
        }

        float[] squares = _levels[level];
        float max = float.NegativeInfinity;
        for (int row = bins.FirstRow >> level; row <= bins.LastRow >> level; row++)
        {
            for (int column = bins.FirstColumn >> level; column <= bins.LastColumn >> level; column++)
            {
                max = MathF.Max(max, squares[(row * edge) + column]);
            }
        }

        return max;
    }
}
