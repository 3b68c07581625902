namespace Msisf.Synthesis;

/// <summary>
/// The base model over a block of its pixels, less the mean of the detail in each pixel, smoothly interpolated. With the detail added,
/// the mean of each pixel is again that of the base, except near the poles (<see cref="BaseHeights"/>).
/// </summary>
internal sealed class BaseSurface
{
    private const int Reach = PixelMeanKernel.Reach;

    private readonly SyntheticTerrain _terrain;
    private readonly int _firstPixelLine;
    private readonly int _pixelLines;
    private readonly int _firstPixel;
    private readonly int _pixels;
    private readonly int _width;
    private readonly double[] _means;
    private MeanSpline? _spline;
    private double[] _lineCoefficients = [];

    /// <summary>Reads the base's heights over a block of pixels and the margin that interpolation needs.</summary>
    /// <param name="terrain">The model.</param>
    /// <param name="firstPixelLine">Northernmost pixel line.</param>
    /// <param name="pixelLines">Number of pixel lines.</param>
    /// <param name="firstPixel">Westernmost pixel.</param>
    /// <param name="pixels">Number of pixels of a line.</param>
    public BaseSurface(SyntheticTerrain terrain, int firstPixelLine, int pixelLines, int firstPixel, int pixels)
    {
        _terrain = terrain;
        _firstPixelLine = firstPixelLine;
        _pixelLines = pixelLines;
        _firstPixel = firstPixel;
        _pixels = pixels;
        _width = pixels + (2 * Reach);
        _means = new double[(pixelLines + (2 * Reach)) * _width];
        for (int line = 0; line < pixelLines + (2 * Reach); line++)
        {
            terrain.Base.ReadHeights(firstPixelLine - Reach + line, firstPixel - Reach, _means.AsSpan(line * _width, _width));
        }
    }

    /// <summary>Subtracts the mean of the detail in each pixel from the base.</summary>
    /// <param name="frame">The block that the detail covers: these pixels and the margin.</param>
    /// <param name="detail">m, lines of the frame's stride.</param>
    public void TakeOffMeans(TileFrame frame, ReadOnlySpan<float> detail)
    {
        int n = _terrain.SamplesPerPixel;
        double[] sums = new double[_width];
        for (int line = 0; line < _pixelLines + (2 * Reach); line++)
        {
            double part = _terrain.Base.HonouredPart(_firstPixelLine - Reach + line) / ((double)n * n);
            Array.Clear(sums);
            for (int inside = 0; inside < n; inside++)
            {
                ReadOnlySpan<float> row = detail.Slice(((line * n) + inside) * frame.Stride, _width * n);
                for (int pixel = 0; pixel < _width; pixel++)
                {
                    double sum = 0.0;
                    foreach (float height in row.Slice(pixel * n, n))
                    {
                        sum += height;
                    }

                    sums[pixel] += sum;
                }
            }

            for (int pixel = 0; pixel < _width; pixel++)
            {
                _means[(line * _width) + pixel] -= part * sums[pixel];
            }
        }
    }

    /// <summary>Turns means into spline coefficients; call it before the first <see cref="ReadLine"/>.</summary>
    public void Prepare()
    {
        _spline = new MeanSpline(_means, _pixelLines, _pixels, _terrain.Kernel);
        _lineCoefficients = new double[_spline.Width];
    }

    /// <summary>One line of the surface plus the detail.</summary>
    /// <param name="line">Line in the whole-Moon grid of samples.</param>
    /// <param name="firstSample">First sample in the whole-Moon grid of samples.</param>
    /// <param name="detail">m, one value for each sample.</param>
    /// <param name="heights">Filled with m over the reference radius.</param>
    public void ReadLine(int line, int firstSample, ReadOnlySpan<float> detail, Span<float> heights)
    {
        int n = _terrain.SamplesPerPixel;
        (int first, double north, double middle, double south) = _terrain.Kernel.At((line / n) - _firstPixelLine, line % n);
        int width = _lineCoefficients.Length;
        ReadOnlySpan<double> rows = _spline!.Rows(first, 3);
        for (int i = 0; i < width; i++)
        {
            _lineCoefficients[i] = (north * rows[i]) + (middle * rows[i + width]) + (south * rows[i + (2 * width)]);
        }

        int pixel = (firstSample / n) - _firstPixel;
        int inside = firstSample % n;
        for (int i = 0; i < heights.Length; i++)
        {
            (int west, double w0, double w1, double w2) = _terrain.Kernel.At(pixel, inside);
            heights[i] = (float)(
                (w0 * _lineCoefficients[west]) + (w1 * _lineCoefficients[west + 1]) + (w2 * _lineCoefficients[west + 2]) + detail[i]);
            if (++inside == n)
            {
                inside = 0;
                pixel++;
            }
        }
    }
}

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
