using Msisf.Core.Detector.Psf;
using Xunit;

namespace Msisf.Core.Tests.Detector.Psf;

/// <summary>Far wings against sums over all pairs of pixels, whose weights are sums over points of each pixel.</summary>
public sealed class WingConvolutionTests
{
    private const double Fraction = 0.3;

    /// <summary>Part of the light: the points of a pixel's grid here, the rules there.</summary>
    private const double SameWeight = 1e-5;

    /// <summary>Part of the light of an image: what is in it and what leaves it are all.</summary>
    private const double SameLight = 1e-6;

    /// <summary>A single bright pixel off the centre of images of odd and even sides, with wings that end in and beyond them.</summary>
    [Theory]
    [InlineData(37, 29, 1.0, 2.5, 500.0)]
    [InlineData(37, 29, 0.7, 3.0, 12.0)]
    [InlineData(16, 64, 3.0, 2.1, 2000.0)]
    [InlineData(1, 40, 1.0, 3.0, 100.0)]
    public void Apply_OnePixel_IsTheFunctionAroundIt(int width, int height, double core, double exponent, double reach)
    {
        (int x, int y) = (width / 3, height / 4);
        double[] image = new double[width * height];
        image[(y * width) + x] = 1000.0;
        bool holdsAll = reach + 1.0 < Math.Min(width, height);
        double total = holdsAll ? Sum(core, exponent, reach) : Total(core, exponent, reach);

        new WingConvolution(new FarWings(Fraction, core, exponent, reach), width, height, 2, CancellationToken.None)
            .Apply(image, 2, CancellationToken.None);

        for (int row = 0; row < height; row++)
        {
            for (int column = 0; column < width; column++)
            {
                double expected = Fraction * Weight(column - x, row - y, core, exponent, reach) / total;
                expected += (column, row) == (x, y) ? 1.0 - Fraction : 0.0;
                Assert.Equal(1000.0 * expected, image[(row * width) + column], 1000.0 * SameWeight * Math.Max(expected, 1e-3));
            }
        }
    }

    /// <summary>Image plus what leaves it is the input, and wings of a sum are the sum of wings.</summary>
    [Theory]
    [InlineData(100, 75, 1.0, 2.1, 800.0)]
    [InlineData(100, 75, 1.0, 2.5, 60.0)]
    [InlineData(64, 128, 2.0, 3.5, 5000.0)]
    public void Apply_ImageAndWhatLeavesIt_AreTheInput(int width, int height, double core, double exponent, double reach)
    {
        WingConvolution wings = new(new FarWings(Fraction, core, exponent, reach), width, height, 1, CancellationToken.None);
        Random random = new(494);
        double[] image = [.. Enumerable.Range(0, width * height).Select(index => index % width > 60 ? 1e4 * random.NextDouble() : 0.0)];
        double[] other = [.. image];
        double input = image.Sum();

        double left = wings.Apply(image, 1, CancellationToken.None);
        double leftAgain = wings.Apply(other, 3, CancellationToken.None);

        Assert.Equal(1.0, (image.Sum() + left) / input, SameLight);
        Assert.True(left > 1e-3 * input && image[width / 2] > 0.0);
        Assert.Equal(image, other); // whatever the number of threads
        Assert.Equal(left, leftAgain);
    }

    /// <summary>The function's integral over the disc within its reach, by rings of a hundredth of a pixel and wider.</summary>
    private static double Total(double core, double exponent, double reach)
    {
        const int Rings = 400_000;
        double sum = 0.0;
        for (int ring = 0; ring < Rings; ring++)
        {
            // Radii are even in the root: narrow where the function is steep.
            (double inner, double outer) = (reach * Math.Pow((double)ring / Rings, 2.0), reach * Math.Pow((ring + 1.0) / Rings, 2.0));
            sum += Math.PI * ((outer * outer) - (inner * inner)) * At(0.5 * (inner + outer), core, exponent);
        }

        return sum;
    }

    /// <summary>The weights of the pixels whose centres lie in the disc.</summary>
    private static double Sum(double core, double exponent, double reach)
    {
        double sum = 0.0;
        int side = (int)reach;
        for (int y = -side; y <= side; y++)
        {
            for (int x = -side; x <= side; x++)
            {
                sum += Weight(x, y, core, exponent, reach);
            }
        }

        return sum;
    }

    /// <summary>The midpoint rule, whose error is that of a rule of half as many points over 4.</summary>
    private static double Weight(int x, int y, double core, double exponent, double reach) => double.Hypot(x, y) > reach
        ? 0.0
        : ((4.0 * Mean(x, y, core, exponent, 64)) - Mean(x, y, core, exponent, 32)) / 3.0;

    private static double Mean(int x, int y, double core, double exponent, int points)
    {
        double sum = 0.0;
        for (int i = 0; i < points; i++)
        {
            for (int j = 0; j < points; j++)
            {
                sum += At(double.Hypot(x + ((i + 0.5) / points) - 0.5, y + ((j + 0.5) / points) - 0.5), core, exponent);
            }
        }

        return sum / (points * points);
    }

    private static double At(double radius, double core, double exponent) =>
        Math.Pow(1.0 + (radius / core * (radius / core)), -0.5 * exponent);
}
