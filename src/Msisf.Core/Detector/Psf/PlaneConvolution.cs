using System.Numerics;
using Msisf.Core.Numerics;
using Msisf.Core.Parallel;

namespace Msisf.Core.Detector.Psf;

/// <summary>
/// Convolutions of images with one symmetric kernel that may be as large as they are, by real Fourier transforms. The result does not
/// depend on the number of threads. Safe for several threads.
/// </summary>
internal sealed class PlaneConvolution
{
    /// <summary>Sequences that are transformed at once.</summary>
    private const int Lanes = 4;

    private readonly int _width;
    private readonly int _height;
    private readonly FourierTransform _across;
    private readonly FourierTransform _down;
    private readonly double[] _kernel; // its transform, which is real: [block of columns, row, column of the block]

    /// <param name="width">Width of the images, px.</param>
    /// <param name="height">px.</param>
    /// <param name="reach">px: the kernel is 0 beyond, along rows and columns.</param>
    /// <param name="kernel">The kernel at a column and a row from its middle, each at least 0; it is the same to all sides.</param>
    public PlaneConvolution(
        int width, int height, int reach, Func<int, int, double> kernel, int threads, CancellationToken cancellation)
    {
        (_width, _height) = (width, height);
        (int reachX, int reachY) = (Math.Min(reach, width - 1), Math.Min(reach, height - 1));
        _across = new FourierTransform(Padded(width + reachX));
        _down = new FourierTransform(Padded(height + reachY));
        (int columns, int rows) = (_across.Length, _down.Length);
        double[] plane = new double[columns * rows];
        for (int y = -reachY; y <= reachY; y++)
        {
            for (int x = -reachX; x <= reachX; x++)
            {
                plane[(((y + rows) % rows) * columns) + ((x + columns) % columns)] = kernel(Math.Abs(x), Math.Abs(y));
            }
        }

        Spectrum spectrum = new(this);
        TransformRows(plane, columns, rows, spectrum, threads, cancellation);
        WorkerTeam.Run(threads, spectrum.Blocks, (_, block) =>
        {
            double[] scratch = new double[2 * rows * Lanes];
            (Memory<double> real, Memory<double> imaginary) = spectrum.BlockOf(block);
            _down.Run(real.Span, imaginary.Span, Lanes, scratch.AsSpan(0, rows * Lanes), scratch.AsSpan(rows * Lanes));
        }, cancellation);
        _kernel = spectrum.Real;
    }

    /// <summary>Replaces an image by its convolution; what falls beyond its borders is lost.</summary>
    /// <param name="image">By rows.</param>
    public void Apply(double[] image, int threads, CancellationToken cancellation)
    {
        Spectrum spectrum = new(this);
        TransformRows(image, _width, _height, spectrum, threads, cancellation);
        int rows = _down.Length;
        WorkerTeam.Run(threads, spectrum.Blocks, (_, block) =>
        {
            double[] scratch = new double[2 * rows * Lanes];
            (Memory<double> real, Memory<double> imaginary) = spectrum.BlockOf(block);
            _down.Run(real.Span, imaginary.Span, Lanes, scratch.AsSpan(0, rows * Lanes), scratch.AsSpan(rows * Lanes));
            ReadOnlySpan<double> factors = _kernel.AsSpan(block * rows * Lanes, rows * Lanes);
            Multiply(real.Span, factors);
            Multiply(imaginary.Span, factors);
            _down.Run(imaginary.Span, real.Span, Lanes, scratch.AsSpan(0, rows * Lanes), scratch.AsSpan(rows * Lanes));
        }, cancellation);
        TransformBack(spectrum, image, threads, cancellation);
    }

    private static int Padded(int length) => (int)BitOperations.RoundUpToPowerOf2((uint)Math.Max(2, length));

    private static void Multiply(Span<double> values, ReadOnlySpan<double> factors)
    {
        for (int i = 0; i < values.Length; i++)
        {
            values[i] *= factors[i];
        }
    }

    /// <summary>
    /// Transforms rows: two real ones as one complex one, whose transform's symmetric and antisymmetric parts are theirs.
    /// </summary>
    private void TransformRows(double[] image, int width, int height, Spectrum spectrum, int threads, CancellationToken cancellation)
    {
        int length = _across.Length;
        WorkerTeam.Run(threads, (height + (2 * Lanes) - 1) / (2 * Lanes), (_, group) =>
        {
            double[] memory = new double[4 * length * Lanes];
            Span<double> real = memory.AsSpan(0, length * Lanes);
            Span<double> imaginary = memory.AsSpan(length * Lanes, length * Lanes);
            for (int lane = 0; lane < Lanes; lane++)
            {
                int first = 2 * ((group * Lanes) + lane);
                Spread(image, width, height, first, real, lane);
                Spread(image, width, height, first + 1, imaginary, lane);
            }

            _across.Run(
                real, imaginary, Lanes, memory.AsSpan(2 * length * Lanes, length * Lanes), memory.AsSpan(3 * length * Lanes));
            for (int column = 0; column <= length / 2; column++)
            {
                int mirrored = (length - column) % length;
                for (int lane = 0; lane < Lanes; lane++)
                {
                    int row = 2 * ((group * Lanes) + lane);
                    if (row >= height)
                    {
                        break;
                    }

                    (double r, double i) = (real[(column * Lanes) + lane], imaginary[(column * Lanes) + lane]);
                    (double mr, double mi) = (real[(mirrored * Lanes) + lane], imaginary[(mirrored * Lanes) + lane]);
                    spectrum.Set(column, row, 0.5 * (r + mr), 0.5 * (i - mi));
                    if (row + 1 < height)
                    {
                        spectrum.Set(column, row + 1, 0.5 * (i + mi), 0.5 * (mr - r));
                    }
                }
            }
        }, cancellation);
    }

    private static void Spread(double[] image, int width, int height, int row, Span<double> target, int lane)
    {
        if (row >= height)
        {
            return;
        }

        ReadOnlySpan<double> source = image.AsSpan(row * width, width);
        for (int column = 0; column < width; column++)
        {
            target[(column * Lanes) + lane] = source[column];
        }
    }

    private void TransformBack(Spectrum spectrum, double[] image, int threads, CancellationToken cancellation)
    {
        int length = _across.Length;
        double scale = 1.0 / ((double)length * _down.Length);
        WorkerTeam.Run(threads, (_height + (2 * Lanes) - 1) / (2 * Lanes), (_, group) =>
        {
            double[] memory = new double[4 * length * Lanes];
            Span<double> real = memory.AsSpan(0, length * Lanes);
            Span<double> imaginary = memory.AsSpan(length * Lanes, length * Lanes);
            for (int lane = 0; lane < Lanes; lane++)
            {
                int row = 2 * ((group * Lanes) + lane);
                for (int column = 0; row < _height && column <= length / 2; column++)
                {
                    (double ar, double ai) = spectrum.Of(column, row);
                    (double br, double bi) = row + 1 < _height ? spectrum.Of(column, row + 1) : (0.0, 0.0);
                    (real[(column * Lanes) + lane], imaginary[(column * Lanes) + lane]) = (ar - bi, ai + br);
                    int mirrored = (length - column) % length;
                    (real[(mirrored * Lanes) + lane], imaginary[(mirrored * Lanes) + lane]) =
                        mirrored == column ? (ar - bi, ai + br) : (ar + bi, br - ai);
                }
            }

            _across.Run(
                imaginary, real, Lanes, memory.AsSpan(2 * length * Lanes, length * Lanes), memory.AsSpan(3 * length * Lanes));
            for (int lane = 0; lane < Lanes; lane++)
            {
                int row = 2 * ((group * Lanes) + lane);
                Gather(real, lane, image, row, scale);
                Gather(imaginary, lane, image, row + 1, scale);
            }
        }, cancellation);
    }

    private void Gather(ReadOnlySpan<double> source, int lane, double[] image, int row, double scale)
    {
        if (row >= _height)
        {
            return;
        }

        Span<double> target = image.AsSpan(row * _width, _width);
        for (int column = 0; column < _width; column++)
        {
            target[column] = scale * source[(column * Lanes) + lane];
        }
    }

    /// <summary>The transforms of real rows: columns up to the middle, some side by side so that each block of them is one piece.</summary>
    private sealed class Spectrum(PlaneConvolution owner)
    {
        private readonly int _rows = owner._down.Length;

        public int Blocks { get; } = ((owner._across.Length / 2) + Lanes) / Lanes;

        public double[] Real { get; } = new double[((owner._across.Length / 2) + Lanes) / Lanes * Lanes * owner._down.Length];

        private readonly double[] _imaginary = new double[((owner._across.Length / 2) + Lanes) / Lanes * Lanes * owner._down.Length];

        public (Memory<double> Real, Memory<double> Imaginary) BlockOf(int block) =>
            (Real.AsMemory(block * _rows * Lanes, _rows * Lanes), _imaginary.AsMemory(block * _rows * Lanes, _rows * Lanes));

        public void Set(int column, int row, double real, double imaginary) =>
            (Real[IndexOf(column, row)], _imaginary[IndexOf(column, row)]) = (real, imaginary);

        public (double Real, double Imaginary) Of(int column, int row) => (Real[IndexOf(column, row)], _imaginary[IndexOf(column, row)]);

        private int IndexOf(int column, int row) => ((((column / Lanes) * _rows) + row) * Lanes) + (column % Lanes);
    }
}
