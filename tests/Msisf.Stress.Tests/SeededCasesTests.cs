using Xunit;

namespace Msisf.Stress.Tests;

public sealed class SeededCasesTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(100)]
    [InlineData(1_000_001)]
    public void Run_AnyNumberOfCases_TriesEachNumberOnceInOrder(int cases) =>
        Assert.Equal(Enumerable.Range(0, cases), SeededCases.Run(cases, 7, () => new Draws()).Drawn.Select(draw => draw.Number));

    [Fact]
    public void Run_SameSeed_GivesTheSame()
    {
        Draws first = SeededCases.Run(1000, 7, () => new Draws());
        Draws second = SeededCases.Run(1000, 7, () => new Draws());
        Draws other = SeededCases.Run(1000, 8, () => new Draws());

        Assert.Equal(first.Drawn, second.Drawn);
        Assert.NotEqual(first.Drawn, other.Drawn);
        Assert.Equal(1000, first.Drawn.Select(draw => draw.Value).Distinct().Count());
    }

    private sealed class Draws : IMeasure<Draws>
    {
        public List<(int Number, double Value)> Drawn { get; } = [];

        public void Try(int number, CaseRandom random) => Drawn.Add((number, random.Unit()));

        public void Add(Draws other) => Drawn.AddRange(other.Drawn);
    }
}
