namespace Msisf.Core.Detector;

/// <summary>Electrons beyond the full well of a pixel.</summary>
internal static class Blooming
{
    /// <summary>
    /// Limits all pixels to the full well. Half of what is beyond it flows up and half down in the column, past full pixels, until there is
    /// room; what reaches the border is lost.
    /// </summary>
    /// <param name="charge">Electrons of each pixel, by rows.</param>
    /// <param name="width">px.</param>
    /// <param name="fullWell">Electrons.</param>
    public static void Spread(Span<double> charge, int width, double fullWell)
    {
        int height = charge.Length / width;
        double[] excess = new double[charge.Length];
        for (int i = 0; i < charge.Length; i++)
        {
            excess[i] = Math.Max(0.0, charge[i] - fullWell);
            charge[i] = Math.Min(charge[i], fullWell);
        }

        // Whole electrons stay whole: the odd one goes down.
        double[] flow = new double[width];
        for (int row = 0; row < height; row++)
        {
            Flow(charge.Slice(row * width, width), flow, fullWell);
            Add(flow, excess.AsSpan(row * width, width), electrons => electrons - Math.Floor(0.5 * electrons));
        }

        Array.Clear(flow);
        for (int row = height - 1; row >= 0; row--)
        {
            Flow(charge.Slice(row * width, width), flow, fullWell);
            Add(flow, excess.AsSpan(row * width, width), electrons => Math.Floor(0.5 * electrons));
        }
    }

    /// <summary>Removes what is beyond the full well.</summary>
    /// <param name="charge">Electrons of each pixel.</param>
    /// <param name="fullWell">Electrons.</param>
    public static void Drain(Span<double> charge, double fullWell)
    {
        foreach (ref double electrons in charge)
        {
            electrons = Math.Min(electrons, fullWell);
        }
    }

    private static void Flow(Span<double> row, Span<double> flow, double fullWell)
    {
        for (int column = 0; column < row.Length; column++)
        {
            double taken = Math.Min(flow[column], fullWell - row[column]);
            row[column] += taken;
            flow[column] -= taken;
        }
    }

    private static void Add(Span<double> flow, ReadOnlySpan<double> excess, Func<double, double> part)
    {
        for (int column = 0; column < excess.Length; column++)
        {
            flow[column] += part(excess[column]);
        }
    }
}
