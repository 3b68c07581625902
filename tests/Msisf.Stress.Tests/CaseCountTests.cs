using Xunit;

namespace Msisf.Stress.Tests;

public sealed class CaseCountTests
{
    [Fact]
    public void ToFigure_NothingTried_KeepsNoLimit() => Assert.False(new CaseCount().ToFigure("q", "", 0.0).IsKept);

    [Fact]
    public void Add_OfParts_CountsAllAndNamesTheFirst()
    {
        CaseCount all = new();
        foreach (string input in new[] { "a", "b", "c" })
        {
            CaseCount part = new();
            part.Add(isWrong: false, () => "right");
            part.Add(isWrong: input != "a", () => input);
            all.Add(part);
        }

        StressFigure figure = all.ToFigure("q", "", 0.0);
        Assert.Equal(2.0, figure.Worst);
        Assert.Equal("b", figure.WorstInput);
        Assert.False(figure.IsKept);
    }
}
