namespace Msisf.Synthesis;

/// <summary>The smooth surface whose means over pixels are given (<see cref="PixelMeanKernel"/>). Immutable.</summary>
internal sealed class MeanSpline
{
    private readonly double[] _coefficients;

    /// <summary>Finds the coefficients.</summary>
    /// <param name="means">Means of the pixels line by line, with <see cref="PixelMeanKernel.Reach"/> more on each side.</param>
    /// <param name="lines">Lines of pixels, without the additional ones.</param>
    /// <param name="pixels">Pixels of a line, without the additional ones.</param>
    /// <param name="kernel">The weights.</param>
    public MeanSpline(ReadOnlySpan<double> means, int lines, int pixels, PixelMeanKernel kernel)
    {
        int all = pixels + (2 * PixelMeanKernel.Reach);
        Width = PixelMeanKernel.CoefficientCount(pixels);
        double[] halfDone = new double[(lines + (2 * PixelMeanKernel.Reach)) * Width];
        for (int line = 0; line < lines + (2 * PixelMeanKernel.Reach); line++)
        {
            kernel.Coefficients(means.Slice(line * all, all), halfDone.AsSpan(line * Width, Width), pixels, step: 1);
        }

        _coefficients = new double[PixelMeanKernel.CoefficientCount(lines) * Width];
        for (int column = 0; column < Width; column++)
        {
            kernel.Coefficients(halfDone.AsSpan(column), _coefficients.AsSpan(column), lines, Width);
        }
    }

    /// <summary>Coefficients of a row.</summary>
    public int Width { get; }

    /// <summary>Rows of coefficients, one after the other.</summary>
    public ReadOnlySpan<double> Rows(int first, int count) => _coefficients.AsSpan(first * Width, count * Width);

    /// <summary>Height at a place.</summary>
    /// <param name="down">Pixels from the upper border of the first line.</param>
    /// <param name="right">Pixels from the left border of the first pixel.</param>
    public double HeightAt(double down, double right)
    {
        (int row, double north, double middle, double south) = PixelMeanKernel.At(down);
        (int column, double west, double centre, double east) = PixelMeanKernel.At(right);
        ReadOnlySpan<double> upper = Rows(row, 1).Slice(column, 3);
        ReadOnlySpan<double> own = Rows(row + 1, 1).Slice(column, 3);
        ReadOnlySpan<double> lower = Rows(row + 2, 1).Slice(column, 3);
        return (west * ((north * upper[0]) + (middle * own[0]) + (south * lower[0])))
            + (centre * ((north * upper[1]) + (middle * own[1]) + (south * lower[1])))
            + (east * ((north * upper[2]) + (middle * own[2]) + (south * lower[2])));
    }
}
