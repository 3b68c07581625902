namespace Msisf.Core.Detector.Psf;

/// <summary>How the light of a point spreads over the pixels around it: a square of weights whose sum is 1. Immutable.</summary>
public sealed class PointSpreadKernel
{
    /// <summary>px: maximum <see cref="Radius"/>; the convolution takes 129 x 129 products a pixel there.</summary>
    public const int MaxRadius = 64;

    private readonly double[] _weights;

    /// <summary>Takes weights and divides them by their sum.</summary>
    /// <param name="weights">
    /// By rows from the top, each from left to right: the image of a point in the middle of the central pixel. Finite, at least 0.
    /// </param>
    /// <exception cref="BadInputException">
    /// Not a square with an odd number of rows, larger than <see cref="MaxRadius"/>, or a weight is out of range.
    /// </exception>
    public PointSpreadKernel(ReadOnlySpan<double> weights)
    {
        int size = (int)Math.Round(Math.Sqrt(weights.Length));
        if (size * size != weights.Length || size % 2 == 0 || size > (2 * MaxRadius) + 1)
        {
            throw new BadInputException(
                $"The PSF kernel has {weights.Length} weights; a square with an odd number of rows is needed, at most "
                    + $"{(2 * MaxRadius) + 1} x {(2 * MaxRadius) + 1}.");
        }

        double sum = 0.0;
        foreach (double weight in weights)
        {
            sum += Guard.InRange(weight, 0.0, double.MaxValue, "A weight of the PSF kernel");
        }

        Guard.Positive(sum, "The sum of the PSF kernel");
        _weights = new double[weights.Length];
        for (int i = 0; i < _weights.Length; i++)
        {
            _weights[i] = weights[i] / sum;
        }

        Radius = size / 2;
        Parts = [new SpreadPart(null, 0.0, _weights, 1.0)];
    }

    /// <summary>px: number of pixels from the central one to the kernel's border.</summary>
    public int Radius { get; }

    /// <summary>Rows, and columns, of the kernel: odd.</summary>
    public int Size => (2 * Radius) + 1;

    /// <summary>By rows from the top, each from left to right; their sum is 1.</summary>
    public ReadOnlySpan<double> Weights => _weights;

    /// <summary>What the kernel was made from: how light spreads from points between the middles of pixels.</summary>
    internal IReadOnlyList<SpreadPart> Parts { get; private init; }

    /// <summary>A formula, cut off at a radius, integrated over each pixel.</summary>
    /// <param name="cutoff">px, 0.5 to <see cref="MaxRadius"/>: the function is 0 beyond.</param>
    public static PointSpreadKernel Of(IRadialSpread spread, double cutoff) => new(PixelIntegrals.Of(spread, cutoff, pixelSide: 1.0))
    {
        Parts = [new SpreadPart(spread, cutoff, [], 1.0)],
    };

    /// <summary>Two kernels that share the light.</summary>
    /// <param name="core">Most of the light.</param>
    /// <param name="wings">The rest.</param>
    /// <param name="fraction">Part of the light in the wings, 0 to 1.</param>
    public static PointSpreadKernel Mix(PointSpreadKernel core, PointSpreadKernel wings, double fraction)
    {
        int radius = Math.Max(core.Radius, wings.Radius);
        double[] sum = new double[((2 * radius) + 1) * ((2 * radius) + 1)];
        core.AddTo(sum, radius, 1.0 - fraction);
        wings.AddTo(sum, radius, fraction);
        return new PointSpreadKernel(sum)
        {
            Parts =
            [
                .. core.Parts.Select(part => part with { Fraction = (1.0 - fraction) * part.Fraction }),
                .. wings.Parts.Select(part => part with { Fraction = fraction * part.Fraction }),
            ],
        };
    }

    private void AddTo(double[] sum, int radius, double factor)
    {
        int margin = radius - Radius;
        for (int row = 0; row < Size; row++)
        {
            for (int column = 0; column < Size; column++)
            {
                sum[((row + margin) * ((2 * radius) + 1)) + column + margin] += factor * _weights[(row * Size) + column];
            }
        }
    }
}

/// <summary>A part of a point spread function.</summary>
/// <param name="Formula">Null for the weights of a file, whose light is even within each of their squares.</param>
/// <param name="Cutoff">px: where the formula ends.</param>
/// <param name="Weights">Weights in a file, by rows; the light of a point in the middle of a pixel.</param>
/// <param name="Fraction">Part of the light.</param>
internal sealed record SpreadPart(IRadialSpread? Formula, double Cutoff, double[] Weights, double Fraction);
