using System.Numerics;
using MathNet.Numerics.IntegralTransforms;

namespace Msisf.Core.Comparison;

/// <summary>Finds by how much a drawn image is shifted against a real one, as a whole and block by block.</summary>
/// <remarks>
/// Normalised correlation of images with gaps by fast Fourier transforms (D. Padfield, IEEE Trans. Image Process. 21 (2012) 2706): each
/// shift has exactly Pearson's correlation of the pixels that both images then have. The sums of all blocks are those of the whole image.
/// The place between pixels is the top of a paraboloid through the best shift and its eight neighbours.
/// </remarks>
public sealed class ShiftFinder
{
    /// <summary>px: side of a block.</summary>
    public const int BlockSide = 64;

    /// <summary>px: greatest shift that is looked for.</summary>
    public const int Reach = 16;

    /// <summary>Blocks of a larger image are every second, third, ... one.</summary>
    private const int MostBlocks = 4096;

    /// <summary>Part of a block's pixels that must have values.</summary>
    private const double LeastPart = 0.25;

    /// <summary>Sums over the pixels that both images have at a shift: count, a, b, ab, aa, bb.</summary>
    private const int Sums = 6;

    private readonly float[] _real;
    private readonly float[] _drawn;
    private readonly int _width;
    private readonly int _height;
    private readonly double _meanReal;
    private readonly double _meanDrawn;

    /// <summary>Takes two images.</summary>
    /// <param name="real">By rows; NaN where there is no value.</param>
    /// <param name="drawn">The same size.</param>
    /// <param name="width">px.</param>
    public ShiftFinder(float[] real, float[] drawn, int width)
    {
        (_real, _drawn, _width, _height) = (real, drawn, width, real.Length / width);

        // Correlations do not depend on what is taken off; near 0 the sums keep their digits.
        _meanReal = MeanOf(real);
        _meanDrawn = MeanOf(drawn);
    }

    /// <summary>Finds the shifts.</summary>
    /// <returns>That of the whole image, null if none is best within the reach; and those of blocks, by rows.</returns>
    public (ImageShift? Whole, IReadOnlyList<BlockShift> Blocks) Find(CancellationToken cancellation)
    {
        (int across, int down) = ((_width + BlockSide - 1) / BlockSide, (_height + BlockSide - 1) / BlockSide);
        int step = (int)Math.Ceiling(Math.Sqrt((double)across * down / MostBlocks));
        (int Left, int Top)[] places =
        [
            .. Enumerable.Range(0, ((down - 1) / step) + 1).SelectMany(
                row => Enumerable.Range(0, ((across - 1) / step) + 1),
                (row, column) => (column * step * BlockSide, row * step * BlockSide)),
        ];
        double[][] sums = new double[places.Length][];
        System.Threading.Tasks.Parallel.For(
            0, places.Length, new ParallelOptions { CancellationToken = cancellation },
            index => sums[index] = SumsOf(places[index].Left, places[index].Top));
        double[] whole = new double[Sums * Shifts * Shifts];
        foreach (double[] block in sums)
        {
            for (int i = 0; i < whole.Length; i++)
            {
                whole[i] += block[i];
            }
        }

        return (
            Best(whole, LeastPart * Math.Min(_real.Length, BlockSide * BlockSide * (double)places.Length)),
            [.. places.Select((place, index) => new BlockShift(
                place.Left, place.Top, Math.Min(BlockSide, _width - place.Left), Math.Min(BlockSide, _height - place.Top),
                Best(
                    sums[index],
                    LeastPart * Math.Min(BlockSide, _width - place.Left) * Math.Min(BlockSide, _height - place.Top))))]);
    }

    private static int Shifts => (2 * Reach) + 1;

    private static double MeanOf(float[] image)
    {
        (double sum, int count) = (0.0, 0);
        foreach (float pixel in image)
        {
            if (float.IsFinite(pixel))
            {
                sum += pixel;
                count++;
            }
        }

        return count == 0 ? 0.0 : sum / count;
    }

    /// <summary>The sums of a block at each shift, [sum, shift down, shift right].</summary>
    private double[] SumsOf(int left, int top)
    {
        int width = Math.Min(BlockSide, _width - left);
        int height = Math.Min(BlockSide, _height - top);
        (int columns, int rows) = (PowerOfTwo(width + (2 * Reach)), PowerOfTwo(height + (2 * Reach)));
        Complex[][] real = Transforms(_real, _meanReal, (left, top), (width, height), (columns, rows));
        Complex[][] drawn = Transforms(
            _drawn, _meanDrawn, (left - Reach, top - Reach), (width + (2 * Reach), height + (2 * Reach)), (columns, rows));
        (int OfReal, int OfDrawn)[] pairs = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2)];
        double[] sums = new double[Sums * Shifts * Shifts];
        for (int sum = 0; sum < Sums; sum++)
        {
            Complex[] product = new Complex[rows * columns];
            for (int i = 0; i < product.Length; i++)
            {
                product[i] = Complex.Conjugate(real[pairs[sum].OfReal][i]) * drawn[pairs[sum].OfDrawn][i];
            }

            Transform(product, columns, Fourier.Inverse);
            for (int down = 0; down < Shifts; down++)
            {
                for (int right = 0; right < Shifts; right++)
                {
                    // The drawn window begins Reach before the block, and moves against the shift.
                    int at = (((2 * Reach) - down) * columns) + (2 * Reach) - right;
                    sums[(((sum * Shifts) + down) * Shifts) + right] = product[at].Real;
                }
            }
        }

        return sums;
    }

    /// <summary>Transforms of the mask, the values and their squares, 0 where there is no value.</summary>
    private Complex[][] Transforms(float[] image, double mean, (int X, int Y) start, (int X, int Y) size, (int X, int Y) padded)
    {
        Complex[][] planes = [.. Enumerable.Range(0, 3).Select(_ => new Complex[padded.X * padded.Y])];
        for (int y = Math.Max(0, -start.Y); y < size.Y && start.Y + y < _height; y++)
        {
            for (int x = Math.Max(0, -start.X); x < size.X && start.X + x < _width; x++)
            {
                float pixel = image[((start.Y + y) * _width) + start.X + x];
                if (float.IsFinite(pixel))
                {
                    int at = (y * padded.X) + x;
                    double value = pixel - mean;
                    (planes[0][at], planes[1][at], planes[2][at]) = (1.0, value, value * value);
                }
            }
        }

        foreach (Complex[] plane in planes)
        {
            Transform(plane, padded.X, Fourier.Forward);
        }

        return planes;
    }

    /// <summary>Transforms rows, then columns; MathNet's own provider has no transform of two dimensions.</summary>
    private static void Transform(Complex[] plane, int columns, Action<Complex[], FourierOptions> transform)
    {
        int rows = plane.Length / columns;
        Complex[] line = new Complex[columns];
        for (int row = 0; row < rows; row++)
        {
            Array.Copy(plane, row * columns, line, 0, columns);
            transform(line, FourierOptions.AsymmetricScaling);
            Array.Copy(line, 0, plane, row * columns, columns);
        }

        line = new Complex[rows];
        for (int column = 0; column < columns; column++)
        {
            for (int row = 0; row < rows; row++)
            {
                line[row] = plane[(row * columns) + column];
            }

            transform(line, FourierOptions.AsymmetricScaling);
            for (int row = 0; row < rows; row++)
            {
                plane[(row * columns) + column] = line[row];
            }
        }
    }

    private static int PowerOfTwo(int least) => (int)BitOperations.RoundUpToPowerOf2((uint)least);

    /// <summary>The shift with the greatest correlation; null if it lies at the end of the reach, or too few pixels count.</summary>
    private static ImageShift? Best(double[] sums, double leastCount)
    {
        double[] correlations = new double[Shifts * Shifts];
        for (int shift = 0; shift < correlations.Length; shift++)
        {
            correlations[shift] = Correlation(sums, shift, leastCount);
        }

        int best = Array.IndexOf(correlations, correlations.Max());
        (int down, int right) = Math.DivRem(best, Shifts);
        bool isInside = down is > 0 and < 2 * Reach && right is > 0 and < 2 * Reach;
        if (!isInside || correlations[best] <= 0.0)
        {
            return null;
        }

        (double x, double y) = Top((row, column) => correlations[best + (row * Shifts) + column]);
        return new ImageShift(
            right - Reach + x, down - Reach + y, correlations[best], correlations[(Reach * Shifts) + Reach]);
    }

    /// <summary>Pearson's correlation at a shift; -1 where it has none.</summary>
    private static double Correlation(double[] sums, int shift, double leastCount)
    {
        double Sum(int of) => sums[(of * Shifts * Shifts) + shift];
        double count = Math.Round(Sum(0));
        if (count < Math.Max(2.0, leastCount))
        {
            return -1.0;
        }

        double ofReal = Sum(4) - (Sum(1) * Sum(1) / count);
        double ofDrawn = Sum(5) - (Sum(2) * Sum(2) / count);

        // The transforms leave 1e-16 of the greatest sums; what is less is an image of one grey.
        const double noise = 1e-12;
        return ofReal > noise * Sum(4) && ofDrawn > noise * Sum(5)
            ? Math.Clamp((Sum(3) - (Sum(1) * Sum(2) / count)) / (Math.Sqrt(ofReal) * Math.Sqrt(ofDrawn)), -1.0, 1.0)
            : -1.0;
    }

    /// <summary>Where the paraboloid through nine values by least squares has its top, from the middle one, at most 1 px.</summary>
    /// <param name="value">The value of a row and column from -1 to 1.</param>
    private static (double Right, double Down) Top(Func<int, int, double> value)
    {
        (double ofX, double ofY, double ofXx, double ofXy, double ofYy) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (int y = -1; y <= 1; y++)
        {
            for (int x = -1; x <= 1; x++)
            {
                double at = value(y, x);
                ofX += x * at / 6.0;
                ofY += y * at / 6.0;
                ofXy += x * y * at / 4.0;
                ofXx += ((0.5 * x * x) - (1.0 / 3.0)) * at;
                ofYy += ((0.5 * y * y) - (1.0 / 3.0)) * at;
            }
        }

        double determinant = (4.0 * ofXx * ofYy) - (ofXy * ofXy);
        return ofXx < 0.0 && determinant > 0.0
            ? (Math.Clamp(((ofXy * ofY) - (2.0 * ofYy * ofX)) / determinant, -1.0, 1.0),
                Math.Clamp(((ofXy * ofX) - (2.0 * ofXx * ofY)) / determinant, -1.0, 1.0))
            : (0.0, 0.0);
    }
}

/// <summary>By how much a drawn image must be moved to lie on the real one.</summary>
/// <param name="Right">px, along the samples.</param>
/// <param name="Down">px, along the lines.</param>
/// <param name="Correlation">After whole pixels of the shift.</param>
/// <param name="Unshifted">Correlation without it.</param>
public readonly record struct ImageShift(double Right, double Down, double Correlation, double Unshifted);

/// <summary>The shift of a block.</summary>
/// <param name="Left">Its first sample, from 0.</param>
/// <param name="Top">Its first line, from 0.</param>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="Shift">Null if none is best within the reach, or the block has too few pixels.</param>
public sealed record BlockShift(int Left, int Top, int Width, int Height, ImageShift? Shift);
