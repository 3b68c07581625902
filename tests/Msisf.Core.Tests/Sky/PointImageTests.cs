using Msisf.Core.Detector.Psf;
using Xunit;

namespace Msisf.Core.Tests.Sky;

/// <summary>The image of a point anywhere in a pixel.</summary>
public sealed class PointImageTests
{
    private const int Width = 41;
    private const double Middle = 21.0;

    /// <summary>Parts of the light: the interpolation between nodes, of a Gaussian of 0.5 px 9 to a pixel.</summary>
    private const double Interpolated = 2e-6;

    /// <summary>Standard normal distribution.</summary>
    private static double Normal(double x) => 0.5 * Erfc(-x / Math.Sqrt(2.0));

    [Theory]
    [InlineData(0.5, 0.0, 0.0)]
    [InlineData(0.5, 0.5, 0.5)]
    [InlineData(0.7, 0.31, -0.47)]
    [InlineData(1.6, -0.123, 0.456)]
    public void Add_Gaussian_IsTheProductOfNormalDistributions(double sigma, double dx, double dy)
    {
        PointImage image = new(PointSpreadKernel.Of(new GaussianSpread(sigma), 12.0));
        double[] pixels = new double[Width * Width];

        double added = image.Add(pixels, Width, (0, Width), Middle + dx, Middle + dy, 3.0);

        Assert.Equal(3.0, added, 1e-12);
        Assert.Equal(3.0, pixels.Sum(), 1e-12);
        for (int row = 0; row < Width; row++)
        {
            for (int column = 0; column < Width; column++)
            {
                double expected = 3.0 * Part(column + 1 - Middle - dx, sigma) * Part(row + 1 - Middle - dy, sigma);
                Assert.Equal(expected, pixels[(row * Width) + column], 3.0 * Interpolated);
            }
        }
    }

    [Fact]
    public void Add_InTheMiddleOfAPixel_IsTheKernel()
    {
        PointSpreadKernel kernel = PointSpreadKernel.Mix(
            PointSpreadKernel.Of(new AirySpread(1.3), 6.0), PointSpreadKernel.Of(new WingSpread(2.0, 2.6), 9.0), 0.1);
        double[] pixels = new double[Width * Width];

        new PointImage(kernel).Add(pixels, Width, (0, Width), Middle, Middle, 1.0);

        for (int y = 0; y < kernel.Size; y++)
        {
            for (int x = 0; x < kernel.Size; x++)
            {
                double actual = pixels[(((int)Middle - 1 - kernel.Radius + y) * Width) + (int)Middle - 1 - kernel.Radius + x];
                Assert.Equal(kernel.Weights[(y * kernel.Size) + x], actual, 1e-6); // cells are integrated each by itself
            }
        }
    }

    /// <summary>A file's kernel is even within its squares, so that half a pixel aside each weight is shared by two pixels.</summary>
    [Fact]
    public void Add_KernelOfAFileHalfAPixelAside_SharesItsWeights()
    {
        PointSpreadKernel kernel = new([0.0, 1.0, 0.0, 2.0, 6.0, 2.0, 0.0, 1.0, 0.0]);
        double[] pixels = new double[Width * Width];

        new PointImage(kernel).Add(pixels, Width, (0, Width), Middle + 0.5, Middle, 12.0);

        Assert.Equal([0.0, 1.0, 4.0, 4.0, 1.0, 0.0], pixels.AsSpan((20 * Width) + 18, 6).ToArray().Select(value => Math.Round(value, 12)));
        Assert.Equal([0.5, 0.5], pixels.AsSpan((19 * Width) + 20, 2).ToArray().Select(value => Math.Round(value, 12)));
    }

    [Fact]
    public void Add_WithoutPsf_IsThePixelThatHoldsThePoint()
    {
        PointImage image = new(null);
        double[] pixels = new double[9];

        Assert.Equal(5.0, image.Add(pixels, 3, (0, 3), 2.49, 0.51, 5.0));
        Assert.Equal(0.0, image.Add(pixels, 3, (0, 3), 3.51, 1.0, 5.0));
        Assert.Equal(0.0, image.Add(pixels, 3, (1, 3), 1.0, 1.0, 5.0));

        Assert.Equal([0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], pixels);
    }

    /// <summary>What falls on an image and what falls beside it are all of the light.</summary>
    [Fact]
    public void Add_AtABorder_ReturnsWhatTheImageGets()
    {
        PointImage image = new(PointSpreadKernel.Of(new GaussianSpread(0.8), 7.0));
        double[] left = new double[Width * Width];
        double[] right = new double[Width * Width];

        double ofLeft = image.Add(left, Width, (0, Width), Width + 0.3, 20.2, 1.0);
        double ofRight = image.Add(right, Width, (0, Width), 0.3, 20.2, 1.0);

        Assert.Equal(left.Sum(), ofLeft, 1e-14);
        Assert.Equal(1.0, ofLeft + ofRight, 1e-12); // the second image lies beside the first
    }

    private static double Part(double distance, double sigma) => Normal((distance + 0.5) / sigma) - Normal((distance - 0.5) / sigma);

    /// <summary>By its series, and beyond 3 by its continued fraction (Abramowitz and Stegun, 7.1.5 and 7.1.14).</summary>
    private static double Erfc(double x)
    {
        if (x < 0.0)
        {
            return 2.0 - Erfc(-x);
        }

        if (x < 3.0)
        {
            double sum = x;
            double term = x;
            for (int n = 1; n < 80; n++)
            {
                term *= -x * x / n;
                sum += term / ((2 * n) + 1);
            }

            return 1.0 - (2.0 / Math.Sqrt(Math.PI) * sum);
        }

        double fraction = 0.0;
        for (int n = 60; n > 0; n--)
        {
            fraction = 0.5 * n / (x + fraction);
        }

        return Math.Exp(-x * x) / (Math.Sqrt(Math.PI) * (x + fraction));
    }
}
