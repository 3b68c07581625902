using Msisf.Core.Numerics;
using Msisf.Core.Parallel;

namespace Msisf.Core.Detector.Psf;

/// <summary>Spreads a part of the light of images of one size by far wings, and counts what leaves. Safe for several threads.</summary>
internal sealed class WingConvolution
{
    /// <summary>px: nearer pixels are integrated in steps of the function's scale, others by Gauss's rule of 3 x 3 to 1e-6.</summary>
    private const int Near = 5;

    /// <summary>px: holds the nearer pixels with their corners.</summary>
    private const double NearCircle = 8.0;

    private static readonly (double Offset, double Weight)[] Gauss =
        [(-0.3872983346207417, 5.0 / 18.0), (0.0, 8.0 / 18.0), (0.3872983346207417, 5.0 / 18.0)]; // sqrt(0.15)

    private readonly int _width;
    private readonly int _height;
    private readonly double[] _weights; // of a quadrant with its axes, by rows: part of a pixel's light
    private readonly double[] _sums; // of the weights from the middle to a column and a row, with them
    private readonly double _whole;
    private readonly PlaneConvolution _convolution;

    /// <param name="width">Width of the images, px.</param>
    /// <param name="height">px.</param>
    public WingConvolution(FarWings wings, int width, int height, int threads, CancellationToken cancellation)
    {
        (_width, _height, _whole) = (width, height, wings.Fraction);
        double[] values = Values(wings, threads, cancellation);
        bool holdsAll = wings.Reach + 1.0 < Math.Min(width, height);
        double factor = wings.Fraction / (holdsAll ? SumOf(values) : wings.Integral);
        _weights = [.. values.Select(value => factor * value)];
        _sums = new double[width * height];
        for (int y = 0; y < height; y++)
        {
            double ofRow = 0.0;
            for (int x = 0; x < width; x++)
            {
                ofRow += _weights[(y * width) + x];
                _sums[(y * width) + x] = ofRow + (y == 0 ? 0.0 : _sums[((y - 1) * width) + x]);
            }
        }

        // What does not spread stays where it is.
        _convolution = new PlaneConvolution(
            width, height, (int)Math.Min(int.MaxValue, Math.Ceiling(wings.Reach)),
            (x, y) => _weights[(y * width) + x] + (x == 0 && y == 0 ? 1.0 - wings.Fraction : 0.0), threads, cancellation);
    }

    /// <summary>Spreads the light of an image.</summary>
    /// <param name="image">By rows.</param>
    /// <returns>How much of it leaves the image.</returns>
    public double Apply(double[] image, int threads, CancellationToken cancellation)
    {
        double[] lostOfRow = new double[_height];
        WorkerTeam.Run(threads, _height, (_, row) =>
        {
            double lost = 0.0;
            for (int column = 0; column < _width; column++)
            {
                lost += image[(row * _width) + column] * (_whole - InsideOf(column, row));
            }

            lostOfRow[row] = lost;
        }, cancellation);
        _convolution.Apply(image, threads, cancellation);
        for (int i = 0; i < image.Length; i++)
        {
            image[i] = Math.Max(0.0, image[i]); // rounding of the transforms, 1e-15 of the brightest pixel
        }

        return lostOfRow.Sum();
    }

    /// <summary>The part of a pixel's light that its wings leave in the image.</summary>
    private double InsideOf(int column, int row)
    {
        (int right, int below) = (_width - 1 - column, _height - 1 - row);
        double quadrants = Sum(column, row) + Sum(right, row) + Sum(column, below) + Sum(right, below);
        double axes = Sum(0, row) + Sum(0, below) + Sum(column, 0) + Sum(right, 0);
        return quadrants - axes + _weights[0]; // the quadrants have each axis twice and the middle four times, the axes that four times
    }

    private double Sum(int column, int row) => _sums[(row * _width) + column];

    /// <summary>All weights of a quadrant's values, to all sides.</summary>
    private double SumOf(double[] values)
    {
        double sum = 0.0;
        for (int y = 0; y < _height; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                sum += (x == 0 ? 1.0 : 2.0) * (y == 0 ? 1.0 : 2.0) * values[(y * _width) + x];
            }
        }

        return sum;
    }

    /// <summary>The integrals of the function over the pixels of a quadrant, not normalised.</summary>
    private double[] Values(FarWings wings, int threads, CancellationToken cancellation)
    {
        WingSpread spread = wings.Spread;
        double circle = Math.Min(NearCircle, wings.Reach);
        double[] near = PixelIntegrals.Of(spread, circle, pixelSide: 1.0);
        int nearRadius = ((int)Math.Round(Math.Sqrt(near.Length)) - 1) / 2;
        double[] values = new double[_width * _height];
        WorkerTeam.Run(threads, _height, (_, y) =>
        {
            for (int x = 0; x < _width; x++)
            {
                values[(y * _width) + x] = x <= Math.Min(Near, nearRadius) && y <= Math.Min(Near, nearRadius)
                    ? near[((nearRadius + y) * ((2 * nearRadius) + 1)) + nearRadius + x]
                    : double.Hypot(x, y) <= wings.Reach ? OfPixel(spread, x, y) : 0.0;
            }
        }, cancellation);
        return values;
    }

    private static double OfPixel(WingSpread spread, int x, int y)
    {
        double sum = 0.0;
        foreach ((double down, double ofRow) in Gauss)
        {
            foreach ((double across, double ofColumn) in Gauss)
            {
                sum += ofRow * ofColumn * spread.At(double.Hypot(x + across, y + down));
            }
        }

        return sum;
    }
}
