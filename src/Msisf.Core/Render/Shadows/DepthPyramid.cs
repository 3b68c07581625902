namespace Msisf.Core.Render.Shadows;

/// <summary>Greatest depth of the receivers in each bin of a grid, and in squares of twice, four times, ... the edge.</summary>
internal sealed class DepthPyramid
{
    /// <summary>Squares to an edge that a question looks at, at most.</summary>
    private const int Window = 3;

    private float[][] _levels = [[]];
    private int _size;

    /// <summary>Makes room.</summary>
    /// <param name="size">Bins to an edge.</param>
    public void Prepare(int size)
    {
        if (size == _size)
        {
            return;
        }

        List<float[]> levels = [];
        for (int edge = size; ; edge = (edge + 1) / 2)
        {
            levels.Add(new float[edge * edge]);
            if (edge == 1)
            {
                break;
            }
        }

        _levels = [.. levels];
        _size = size;
    }

    /// <summary>m, of each bin, row by row; minus infinity where no receiver is. <see cref="Finish"/> takes them up.</summary>
    public float[] Bins => _levels[0];

    /// <summary>Makes the coarser levels.</summary>
    public void Finish()
    {
        int edge = _size;
        for (int level = 1; level < _levels.Length; level++)
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

    /// <summary>No receiver in some bins is deeper; m, minus infinity if there is none. Looks at few squares, so it may say too much.</summary>
    public float Greatest(int firstColumn, int lastColumn, int firstRow, int lastRow)
    {
        int level = 0;
        int edge = _size;
        while (Math.Max((lastColumn >> level) - (firstColumn >> level), (lastRow >> level) - (firstRow >> level)) >= Window)
        {
            level++;
            edge = (edge + 1) / 2;
        }

        float[] squares = _levels[level];
        float greatest = float.NegativeInfinity;
        for (int row = firstRow >> level; row <= lastRow >> level; row++)
        {
            for (int column = firstColumn >> level; column <= lastColumn >> level; column++)
            {
                greatest = MathF.Max(greatest, squares[(row * edge) + column]);
            }
        }

        return greatest;
    }
}
