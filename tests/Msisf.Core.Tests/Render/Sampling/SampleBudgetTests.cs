using Msisf.Core.Render.Sampling;
using Xunit;

namespace Msisf.Core.Tests.Render.Sampling;

/// <summary>How samples are spread over contrasts.</summary>
public sealed class SampleBudgetTests
{
    [Fact]
    public void VectorsOf_MoreContrast_AreNotFewer()
    {
        byte[] vectors = SampleBudget.VectorsOf(Even(), 0.5);

        Assert.Equal(0, vectors[0]);
        Assert.Equal(8, vectors[255]);
        Assert.All(Enumerable.Range(1, 255), contrast => Assert.True(vectors[contrast] >= vectors[contrast - 1], $"contrast {contrast}"));
    }

    [Fact]
    public void VectorsOf_SmallerError_AreNotFewerAnywhere()
    {
        byte[] rough = SampleBudget.VectorsOf(Even(), 1.0);
        byte[] fine = SampleBudget.VectorsOf(Even(), 0.3);

        Assert.All(rough.Zip(fine), pair => Assert.True(pair.Second >= pair.First));
        Assert.True(fine.Sum(count => count) > rough.Sum(count => count));
    }

    /// <summary>With one contrast of 4 levels one sample leaves 0.152 * 4 = 0.61 levels, eight leave 0.039 * 4 = 0.16.</summary>
    [Theory]
    [InlineData(1.0, 0)]
    [InlineData(0.6, 1)]
    [InlineData(0.05, 4)]
    [InlineData(0.01, 8)]
    public void VectorsOf_OneContrast_AreAsFewAsTheErrorAllows(double error, int expected)
    {
        int[] histogram = new int[256];
        histogram[4] = 1000;

        Assert.Equal(expected, SampleBudget.VectorsOf(histogram, error)[4]);
    }

    [Fact]
    public void VectorsOf_AnImageWithoutContrast_AreNone()
    {
        int[] histogram = new int[256];
        histogram[0] = 1000;

        Assert.Equal(0, SampleBudget.VectorsOf(histogram, 0.05)[0]);
    }

    /// <summary>As many pixels of each contrast.</summary>
    private static int[] Even() => [.. Enumerable.Repeat(100, 256)];
}
