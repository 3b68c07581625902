namespace Msisf.Core.Render.Shadows;

/// <summary>Maximum depth of the receivers in each bin of a grid and, on coarser levels, in squares of 2, 4, 8 ... bins a side.</summary>
internal sealed class DepthPyramid
{
    /// <summary>Maximum number of squares along each edge that <see cref="Max"/> reads; limits its cost to 9 values.</summary>
    private const int Window = 3;

    private readonly List<float[]> _levels = [];
    private int _size;

    /// <summary>Makes room for a grid.</summary>
    /// <param name="size">Number of bins along each edge of the grid.</param>
    /// <param name="maxSize">Maximum of that number in later frames of the same size.</param>
    public void Prepare(int size, int maxSize)
    {
        _size = size;
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
        int edge = _size;
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

    /// <summary>
    /// Upper bound of the depth of all receivers in a range of bins, m; below any real depth if there is none. It can exceed
    /// the maximum, because the squares that are read may extend beyond the range.
    /// </summary>
    public float Max(GridRange bins)
    {
        int level = 0;
        int edge = _size;
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
