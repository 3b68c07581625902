using Xunit;

namespace Msisf.Stress.Tests;

public sealed class CasePartsTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(100)]
    [InlineData(10_000_001)]
    public void Run_AnyNumberOfCases_SharesAllOfThem(long cases) =>
        Assert.Equal(cases, CaseParts.Run(cases, seed: 1, (_, count) => count).Sum());

    [Fact]
    public void Run_Twice_GivesTheSameNumbersInTheSameOrder()
    {
        IReadOnlyList<double> first = CaseParts.Run(64, seed: 1, (random, _) => random.Unit());
        Assert.Equal(first, CaseParts.Run(64, seed: 1, (random, _) => random.Unit()));
        Assert.Equal(first.Count, first.Distinct().Count());
    }
}
