namespace Msisf.Core.Terrain.Synthesis;

/// <summary>The base model over a block of its pixels, less the means of the detail, interpolated smoothly: the sum with the detail has the base's means (<see cref="BaseHeights"/>: but for the polar caps).</summary>
internal sealed class BaseSurface
{
    private const int Reach = PixelMeanKernel.Reach;

    private readonly SyntheticTerrain terrain;
    private readonly int firstPixelLine;
    private readonly int pixelLines;
    private readonly int firstPixel;
    private readonly int pixels;
    private readonly int width;
    private readonly double[] means;
    private readonly int coefficientWidth;
    private readonly double[] coefficients;
    private readonly double[] lineCoefficients;

    /// <summary>Reads the base's heights over a block of pixels and the margin that interpolation needs.</summary>
    /// <param name="terrain">The model.</param>
    /// <param name="firstPixelLine">Northernmost pixel line.</param>
    /// <param name="pixelLines">How many.</param>
    /// <param name="firstPixel">Westernmost pixel.</param>
    /// <param name="pixels">How many.</param>
    public BaseSurface(SyntheticTerrain terrain, int firstPixelLine, int pixelLines, int firstPixel, int pixels)
    {
        this.terrain = terrain;
        this.firstPixelLine = firstPixelLine;
        this.pixelLines = pixelLines;
        this.firstPixel = firstPixel;
        this.pixels = pixels;
        width = pixels + (2 * Reach);
        means = new double[(pixelLines + (2 * Reach)) * width];
        coefficientWidth = PixelMeanKernel.CoefficientCount(pixels);
        coefficients = new double[PixelMeanKernel.CoefficientCount(pixelLines) * coefficientWidth];
        lineCoefficients = new double[coefficientWidth];
        for (int line = 0; line < pixelLines + (2 * Reach); line++)
        {
            terrain.Base.ReadHeights(firstPixelLine - Reach + line, firstPixel - Reach, means.AsSpan(line * width, width));
        }
    }

    /// <summary>Takes the mean of the detail in each pixel off the base.</summary>
    /// <param name="frame">The block of the detail: these pixels and the margin.</param>
    /// <param name="detail">m, lines of the frame's stride.</param>
    public void TakeOffMeans(TileFrame frame, ReadOnlySpan<float> detail)
    {
        int n = terrain.SamplesPerPixel;
        double[] sums = new double[width];
        for (int line = 0; line < pixelLines + (2 * Reach); line++)
        {
            double part = terrain.Base.HonouredPart(firstPixelLine - Reach + line) / ((double)n * n);
            Array.Clear(sums);
            for (int inside = 0; inside < n; inside++)
            {
                ReadOnlySpan<float> row = detail.Slice(((line * n) + inside) * frame.Stride, width * n);
                for (int pixel = 0; pixel < width; pixel++)
                {
                    double sum = 0.0;
                    foreach (float height in row.Slice(pixel * n, n))
                    {
                        sum += height;
                    }

                    sums[pixel] += sum;
                }
            }

            for (int pixel = 0; pixel < width; pixel++)
            {
                means[(line * width) + pixel] -= part * sums[pixel];
            }
        }
    }

    /// <summary>Turns means into spline coefficients; before the first <see cref="ReadLine"/>.</summary>
    public void Prepare()
    {
        double[] halfDone = new double[(pixelLines + (2 * Reach)) * coefficientWidth];
        for (int line = 0; line < pixelLines + (2 * Reach); line++)
        {
            terrain.Kernel.Coefficients(
                means.AsSpan(line * width, width),
                halfDone.AsSpan(line * coefficientWidth, coefficientWidth),
                pixels,
                step: 1);
        }

        for (int column = 0; column < coefficientWidth; column++)
        {
            terrain.Kernel.Coefficients(halfDone.AsSpan(column), coefficients.AsSpan(column), pixelLines, coefficientWidth);
        }
    }

    /// <summary>One line of the surface plus the detail.</summary>
    /// <param name="line">In the whole-Moon grid of samples.</param>
    /// <param name="firstSample">In the whole-Moon grid of samples.</param>
    /// <param name="detail">m, one a sample.</param>
    /// <param name="heights">Filled with m over the reference radius.</param>
    public void ReadLine(int line, int firstSample, ReadOnlySpan<float> detail, Span<float> heights)
    {
        int n = terrain.SamplesPerPixel;
        (int first, double north, double middle, double south) = terrain.Kernel.At((line / n) - firstPixelLine, line % n);
        ReadOnlySpan<double> rows = coefficients.AsSpan(first * coefficientWidth, 3 * coefficientWidth);
        for (int i = 0; i < coefficientWidth; i++)
        {
            lineCoefficients[i] = (north * rows[i]) + (middle * rows[i + coefficientWidth]) + (south * rows[i + (2 * coefficientWidth)]);
        }

        int pixel = (firstSample / n) - firstPixel;
        int inside = firstSample % n;
        for (int i = 0; i < heights.Length; i++)
        {
            (int west, double w0, double w1, double w2) = terrain.Kernel.At(pixel, inside);
            heights[i] = (float)((w0 * lineCoefficients[west]) + (w1 * lineCoefficients[west + 1]) + (w2 * lineCoefficients[west + 2]) + detail[i]);
            if (++inside == n)
            {
                inside = 0;
                pixel++;
            }
        }
    }
}
