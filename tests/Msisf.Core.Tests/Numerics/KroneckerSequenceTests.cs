using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class KroneckerSequenceTests
{
    private const int Dimensions = 16;
    private const int Bins = 16;

    /// <summary>Chi-square that 1 % of random counts in 16 bins exceed (15 degrees of freedom).</summary>
    private const double OnePercent = 30.58;

    /// <summary>
    /// Sums and differences of any two coordinates are as even as the coordinates: in each of 20 seeds, where one might exceed the limit.
    /// </summary>
    [Theory]
    [InlineData(512)]
    [InlineData(1024)]
    public void PointAt_SumsAndDifferencesOfAnyTwo_FillTheirRangeEvenly(int count)
    {
        for (ulong seed = 1; seed <= 20; seed++)
        {
            double[][] points = Points(new KroneckerSequence(Dimensions, seed, stream: (long)seed % 3), count);
            for (int i = 0; i < Dimensions; i++)
            {
                for (int j = 0; j < i; j++)
                {
                    Assert.InRange(ChiSquare(points.Select(point => point[i] + point[j])), 0.0, OnePercent);
                    Assert.InRange(ChiSquare(points.Select(point => point[i] - point[j])), 0.0, OnePercent);
                }
            }
        }
    }

    /// <summary>Other counts, and points from somewhere on.</summary>
    [Theory]
    [InlineData(0, 256)]
    [InlineData(0, 300)]
    [InlineData(0, 700)]
    [InlineData(1000, 500)]
    public void PointAt_AnyPart_IsMoreEvenThanRandomPoints(int first, int count)
    {
        KroneckerSequence sequence = new(Dimensions, seed: 7, stream: 0);
        double[][] points = [.. Enumerable.Range(first, count).Select(number => sequence.PointAt(number))];
        for (int i = 0; i < Dimensions; i++)
        {
            Assert.InRange(ChiSquare(points.Select(point => point[i])), 0.0, 10.0); // of random ones the mean is 15
            for (int j = 0; j < i; j++)
            {
                Assert.InRange(ChiSquare(points.Select(point => point[i] + point[j])), 0.0, OnePercent);
                Assert.InRange(ChiSquare(points.Select(point => point[i] - point[j])), 0.0, OnePercent);
            }
        }
    }

    /// <summary>Any two coordinates by themselves: each of 16 parts of the square holds some of 512 points, on average 32.</summary>
    [Fact]
    public void PointAt_AnyTwo_FillTheSquareEvenly()
    {
        double[][] points = Points(new KroneckerSequence(Dimensions, seed: 11, stream: 2), 512);
        for (int i = 0; i < Dimensions; i++)
        {
            for (int j = 0; j < i; j++)
            {
                int[] counts = new int[16];
                Array.ForEach(points, point => counts[(4 * (int)(4.0 * point[i])) + (int)(4.0 * point[j])]++);
                Assert.All(counts, count => Assert.InRange(count, 16, 54));
            }
        }
    }

    /// <summary>
    /// python3 -c "print(*(3 * a % 2**64 / 2**64 for a in (0x98D9DAC374342801, 0xEF656278051F0801)))": the way from point 0 to point 3.
    /// </summary>
    [Fact]
    public void PointAt_Number_IsSoManyStepsFromTheFirst()
    {
        KroneckerSequence sequence = new(2, seed: 1, stream: 0);
        double[] origin = sequence.PointAt(0);
        double[] point = sequence.PointAt(3);

        Assert.Equal(0.7912225896403572, Fraction(point[0] - origin[0]), 1e-15);
        Assert.Equal(0.8054222706845063, Fraction(point[1] - origin[1]), 1e-15);
    }

    [Fact]
    public void PointAt_OtherSeedOrStream_IsAnother()
    {
        double[] point = new KroneckerSequence(Dimensions, seed: 42, stream: 3).PointAt(256);

        Assert.NotEqual(point, new KroneckerSequence(Dimensions, seed: 43, stream: 3).PointAt(256));
        Assert.NotEqual(point, new KroneckerSequence(Dimensions, seed: 42, stream: 4).PointAt(256));
    }

    [Fact]
    public void UnitCubePoints_RandomOnes_AreThoseOfTheirNumber()
    {
        UnitCubePoints random = new(Dimensions, isEven: false, seed: 5, stream: 0);
        double[][] points = [.. Enumerable.Range(0, 4096).Select(number => random.PointAt(number))];

        Assert.Equal(points[17], new UnitCubePoints(Dimensions, isEven: false, seed: 5, stream: 0).PointAt(17));
        Assert.NotEqual(points[17], new UnitCubePoints(Dimensions, isEven: true, seed: 5, stream: 0).PointAt(17));
        Assert.Equal(0.5, points.Average(point => point.Average()), 0.005);
        Assert.NotEqual(random.PointAt(3), new UnitCubePoints(Dimensions, isEven: false, seed: 6, stream: 0).PointAt(3));
    }

    private static double[][] Points(KroneckerSequence sequence, int count) =>
        [.. Enumerable.Range(0, count).Select(number => sequence.PointAt(number))];

    private static double ChiSquare(IEnumerable<double> numbers)
    {
        int[] counts = new int[Bins];
        foreach (double number in numbers)
        {
            counts[(int)(Bins * Fraction(number))]++;
        }

        double expected = counts.Sum() / (double)Bins;
        return counts.Sum(count => (count - expected) * (count - expected) / expected);
    }

    private static double Fraction(double number) => number - Math.Floor(number);
}
