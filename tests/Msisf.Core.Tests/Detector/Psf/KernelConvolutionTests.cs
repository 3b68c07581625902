using Msisf.Core.Detector.Psf;
using Xunit;

namespace Msisf.Core.Tests.Detector.Psf;

public sealed class KernelConvolutionTests
{
    private const double KeptSum = 1e-9; // asked: a point's light, relative

    [Fact]
    public void Row_PointOfLight_BecomesTheKernelAndKeepsItsSum()
    {
        // Not symmetric, so that a mirrored or a transposed kernel is seen.
        double[] weights = [.. Enumerable.Range(1, 225).Select(number => (double)(number * number % 31) + 0.5)];
        PointSpreadKernel kernel = new(weights);
        (int width, int height) = (75, 40);
        (int x, int y) = (41, 20);
        double[] source = new double[(width + 14) * (height + 14)];
        source[((y + 7) * (width + 14)) + x + 7] = 1000.0;
        double[] image = Convolve(source, width, height, kernel);
        Assert.InRange(image.Sum(), 1000.0 * (1.0 - KeptSum), 1000.0 * (1.0 + KeptSum));
        for (int row = 0; row < height; row++)
        {
            for (int column = 0; column < width; column++)
            {
                (int dx, int dy) = (column - x + 7, row - y + 7);
                double expected = dx is >= 0 and < 15 && dy is >= 0 and < 15 ? 1000.0 * weights[(dy * 15) + dx] / weights.Sum() : 0.0;
                Assert.Equal(expected, image[(row * width) + column], 10);
            }
        }
    }

    /// <summary>Every width takes other paths of the code: 32 columns at once, 4, 1.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(5)]
    [InlineData(34)]
    [InlineData(67)]
    public void Row_EvenLight_StaysEven(int width)
    {
        PointSpreadKernel kernel = PointSpreadKernel.Of(new GaussianSpread(1.1), 4.0);
        double[] source = new double[(width + 8) * 11];
        Array.Fill(source, 3.0);
        Assert.All(Convolve(source, width, 3, kernel), value => Assert.Equal(3.0, value, 13));
    }

    private static double[] Convolve(double[] source, int width, int height, PointSpreadKernel kernel)
    {
        double[] image = new double[width * height];
        for (int row = 0; row < height; row++)
        {
            KernelConvolution.Row(source, width + (2 * kernel.Radius), kernel, row, image.AsSpan(row * width, width));
        }

        return image;
    }
}
