namespace Msisf.Core.Render.Shadows;

/// <summary>Maximum depth of the receivers in each bin of a grid, and in squares of twice, four times, ... the edge.</summary>
internal sealed class DepthPyramid
{
    /// <summary>Squares to an edge that a question looks at, at most.</summary>
    private const int Window = 3;

    private readonly List<float[]> _levels = [];
    private int _size;

    /// <summary>Makes room.</summary>
    /// <param name="size">Bins to an edge.</param>
    public void Prepare(int size)
    {
        _size = size;
        int level = 0;
        for (int edge = size; ; edge = (edge + 1) / 2, level++)
        {
            if (level == _levels.Count)
            {
                _levels.Add([]);
            }

            if (_levels[level].Length < edge * edge)
            {
                _levels[level] = new float[edge * edge * 5 / 4];
            }

            if (edge == 1)
            {
                break;
            }
        }
    }

    /// <summary>m, of each bin, row by row; minus infinity where no receiver is. <see cref="Finish"/> takes them up.</summary>
    public float[] Bins => _levels[0];

    /// <summary>Makes the coarser levels.</summary>
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
    /// No receiver in some bins is deeper; m, minus infinity if there is none. Looks at few squares, so it may say too much.
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
