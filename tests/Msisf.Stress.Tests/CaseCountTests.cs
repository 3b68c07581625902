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
            part.Note(isWrong: false, () => "right");
            part.Note(isWrong: input != "a", () => input);
            all.Add(part);
        }

        StressFigure figure = all.ToFigure("q", "", 0.0);
        Assert.Equal(2.0, figure.Worst);
        Assert.Equal("b", figure.WorstInput);
        Assert.False(figure.IsKept);
    }

    [Fact]
    public void Note_SeveralOfAnInput_CountsThem()
    {
        CaseCount count = new();
        count.Note(wrong: 0, tried: 5, () => "none");
        Assert.Equal(new StressFigure("q", "", 0.0, 0.0, "none of 5"), count.ToFigure("q", "", 0.0));
        count.Note(wrong: 3, tried: 5, () => "three");
        count.Note(wrong: 4, tried: 5, () => "four");
        Assert.Equal(new StressFigure("q", "", 7.0, 0.0, "three"), count.ToFigure("q", "", 0.0));
    }
}
