using Xunit;

namespace Msisf.Stress.Tests;

public sealed class SeededCasesTests
{
    [Fact]
    public void Run_SameSeed_TriesEachNumberOnceAndGivesTheSame()
    {
        Draws first = SeededCases.Run(1000, 7, () => new Draws());
        Draws second = SeededCases.Run(1000, 7, () => new Draws());
        Draws other = SeededCases.Run(1000, 8, () => new Draws());

        Assert.Equal(Enumerable.Range(0, 1000), first.Drawn.Select(draw => draw.Number).Order());
        Assert.Equal(first.Drawn, second.Drawn);
        Assert.NotEqual(first.Drawn, other.Drawn);
    }

    private sealed class Draws : IMeasure<Draws>
    {
        public List<(int Number, double Value)> Drawn { get; } = [];

        public IEnumerable<StressFigure> Figures => [];

        public IEnumerable<StressSeries> Series => [];

        public void Try(int number, Random random) => Drawn.Add((number, random.NextDouble()));

        public void Add(Draws other) => Drawn.AddRange(other.Drawn);
    }
}
