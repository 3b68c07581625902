using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class SobolSequenceTests
{
    /// <summary>
    /// python3 -c "from scipy.stats import qmc; print(qmc.Sobol(16, scramble=False, bits=52).random(1024)[[1, 5, 1000]])".
    /// </summary>
    [Theory]
    [InlineData(1, new[] { 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5 })]
    [InlineData(5, new[]
        { 0.875, 0.875, 0.125, 0.375, 0.875, 0.625, 0.875, 0.375, 0.375, 0.125, 0.375, 0.875, 0.875, 0.125, 0.875, 0.375 })]
    [InlineData(1000, new[]
    {
        0.2197265625, 0.0966796875, 0.5185546875, 0.6767578125, 0.2802734375, 0.9072265625, 0.0458984375, 0.8994140625, 0.5009765625,
        0.0693359375, 0.0849609375, 0.2548828125, 0.1611328125, 0.3837890625, 0.1435546875, 0.3701171875,
    })]
    public void PointAt_WithoutSeed_IsThatOfScipy(long number, double[] expected) =>
        Assert.Equal(expected, new SobolSequence(16, seed: null).PointAt(number));

    /// <summary>Of each 16 points in a row every sixteenth of each coordinate has one; of all 256 in two coordinates each square.</summary>
    [Fact]
    public void PointAt_WithSeed_StaysAsEven()
    {
        SobolSequence sequence = new(16, seed: 42, stream: 3);
        double[][] points = [.. Enumerable.Range(256, 256).Select(number => sequence.PointAt(number))];
        for (int dimension = 0; dimension < 16; dimension++)
        {
            Assert.All(
                points.Chunk(16), chunk => Assert.Equal(16, chunk.Select(point => (int)(16.0 * point[dimension])).Distinct().Count()));
        }

        Assert.Equal(256, points.Select(point => ((int)(16.0 * point[0]), (int)(16.0 * point[1]))).Distinct().Count());
        Assert.NotEqual(points[0], new SobolSequence(16, seed: 43, stream: 3).PointAt(256));
        Assert.NotEqual(points[0], new SobolSequence(16, seed: 42, stream: 4).PointAt(256));
    }

    [Fact]
    public void UnitCubePoints_AtRandom_FillTheCubeAndRepeat()
    {
        UnitCubePoints random = new(16, isSobol: false, seed: 5, stream: 0);
        double[][] points = [.. Enumerable.Range(0, 4000).Select(number => random.PointAt(number))];
        for (int dimension = 0; dimension < 16; dimension++)
        {
            Assert.InRange(points.Average(point => point[dimension]), 0.48, 0.52); // four standard deviations
            Assert.InRange(points.Average(point => point[dimension] * point[dimension]), 0.313, 0.353);
        }

        Assert.Equal(points[17], new UnitCubePoints(16, isSobol: false, seed: 5, stream: 0).PointAt(17));
        Assert.NotEqual(points[17], new UnitCubePoints(16, isSobol: true, seed: 5, stream: 0).PointAt(17));
    }
}
