using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public sealed class LaneHypotTests
{
    /// <summary>Powers of two between the two numbers: 0 for equal exponents, more than 54 for a number that does not count.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(3, 0)]
    [InlineData(54, 0)]
    [InlineData(60, 0)]
    [InlineData(20, 300)]
    [InlineData(20, 900)]
    [InlineData(20, -900)]
    public void Of_NumbersOfAnySize_HasTheBitsOfTheLibrary(int exponents, int scale)
    {
        Random random = new(20120222);
        for (int i = 0; i < 2000; i++)
        {
            Vector512<double> x = Numbers(random, scale);
            Vector512<double> y = Numbers(random, scale + random.Next(-exponents - 1, exponents + 2));

            AssertSame(x, y, LaneHypot.Of(x, y));
        }
    }

    [Fact]
    public void Of_ZeroAndWhatIsNotFinite_HasTheBitsOfTheLibrary()
    {
        Vector512<double> x = Vector512.Create(0.0, -0.0, 0.0, 3.0, double.NaN, double.PositiveInfinity, double.Epsilon, double.MaxValue);
        Vector512<double> y = Vector512.Create(0.0, 0.0, -7.5, 4.0, 1.0, double.NaN, double.Epsilon, double.MaxValue);

        AssertSame(x, y, LaneHypot.Of(x, y));
        AssertSame(Vector512.Create(3.0), Vector512<double>.Zero, LaneHypot.Of(Vector512.Create(3.0), Vector512<double>.Zero));
    }

    [Fact]
    public void Lengths_Row_AreThoseOfTheVectors()
    {
        Random random = new(20120222);
        VectorRow row = VectorRow.OfLength(24);
        for (int i = 0; i < 17; i++)
        {
            (row.X[i], row.Y[i], row.Z[i]) = (1e6 * random.NextDouble(), -2e6 * random.NextDouble(), random.NextDouble());
        }

        double[] lengths = new double[24];
        double[] distances = new double[24];
        LaneHypot.Lengths(row, 17, lengths);
        LaneHypot.AxisDistances(row, 17, distances);

        for (int i = 0; i < 17; i++)
        {
            Assert.Equal(row[i].Length, lengths[i]);
            Assert.Equal(double.Hypot(row.X[i], row.Y[i]), distances[i]);
        }
    }

    private static Vector512<double> Numbers(Random random, int exponent)
    {
        double[] numbers = new double[Vector512<double>.Count];
        for (int lane = 0; lane < numbers.Length; lane++)
        {
            numbers[lane] = Math.ScaleB(random.Next(2) == 0 ? 1.0 + random.NextDouble() : -1.0 - random.NextDouble(), exponent);
        }

        return Vector512.Create(numbers);
    }

    private static void AssertSame(Vector512<double> x, Vector512<double> y, Vector512<double> actual)
    {
        for (int lane = 0; lane < Vector512<double>.Count; lane++)
        {
            Assert.Equal(
                BitConverter.DoubleToUInt64Bits(double.Hypot(x[lane], y[lane])), BitConverter.DoubleToUInt64Bits(actual[lane]));
        }
    }
}
