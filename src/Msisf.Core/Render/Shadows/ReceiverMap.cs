namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Where in light space the receivers are, coarsely: the depth of the deepest one in each square of a regular grid, and of squares of
/// twice, four times, ... the edge. Terrain that is deeper than all receivers behind it casts no shadow that is seen.
/// </summary>
internal sealed class ReceiverMap
{
    private const int Levels = 10;
    private const int Size = 1 << (Levels - 1);

    private readonly float[][] _levels;
    private LightAxis _u;
    private LightAxis _v;

    public ReceiverMap() =>
        _levels = [.. Enumerable.Range(0, Levels).Select(level => new float[(Size >> level) * (Size >> level)])];

    /// <summary>Forgets all receivers.</summary>
    /// <param name="box">Where most of the next ones will be; the map is right for those outside too.</param>
    public void Clear(LightBox box)
    {
        _u = new LightAxis(box.LeastU, box.GreatestU, Size);
        _v = new LightAxis(box.LeastV, box.GreatestV, Size);
        Array.Fill(_levels[0], float.NegativeInfinity);
    }

    /// <summary>Adds receivers. Several threads may add at the same time: the greatest depth does not depend on their order.</summary>
    public void Add(ReadOnlySpan<double> u, ReadOnlySpan<double> v, ReadOnlySpan<double> w)
    {
        float[] greatest = _levels[0];
        for (int i = 0; i < u.Length; i++)
        {
            ref float square = ref greatest[(_v.BinOf(v[i]) * Size) + _u.BinOf(u[i])];
            float depth = MathF.BitIncrement((float)w[i]);
            float seen = Volatile.Read(ref square);
            while (depth > seen)
            {
                float before = Interlocked.CompareExchange(ref square, depth, seen);
                if (before == seen)
                {
                    break;
                }

                seen = before;
            }
        }
    }

    /// <summary>Makes the coarser levels; call it after the last <see cref="Add"/>.</summary>
    public void Finish()
    {
        for (int level = 1; level < Levels; level++)
        {
            int size = Size >> level;
            for (int row = 0; row < size; row++)
            {
                ReadOnlySpan<float> north = _levels[level - 1].AsSpan(4 * row * size, 2 * size);
                ReadOnlySpan<float> south = _levels[level - 1].AsSpan((4 * row * size) + (2 * size), 2 * size);
                Span<float> line = _levels[level].AsSpan(row * size, size);
                for (int column = 0; column < line.Length; column++)
                {
                    line[column] = MathF.Max(
                        MathF.Max(north[2 * column], north[(2 * column) + 1]), MathF.Max(south[2 * column], south[(2 * column) + 1]));
                }
            }
        }
    }

    /// <summary>No receiver in a box is deeper; m, minus infinity if there is none. Looks at few squares, so it may say too much.</summary>
    public float GreatestDepth(LightBox box)
    {
        int firstColumn = _u.BinOf(box.LeastU);
        int lastColumn = _u.BinOf(box.GreatestU);
        int firstRow = _v.BinOf(box.LeastV);
        int lastRow = _v.BinOf(box.GreatestV);
        int level = 0;
        while (Math.Max(lastColumn - firstColumn, lastRow - firstRow) >> level > 2)
        {
            level++;
        }

        float[] squares = _levels[level];
        float greatest = float.NegativeInfinity;
        for (int row = firstRow >> level; row <= lastRow >> level; row++)
        {
            for (int column = firstColumn >> level; column <= lastColumn >> level; column++)
            {
                greatest = MathF.Max(greatest, squares[(row * (Size >> level)) + column]);
            }
        }

        return greatest;
    }
}
