using Xunit;

namespace Msisf.Stress.Tests;

public sealed class WorstCaseTests
{
    [Fact]
    public void ToFigure_NoCase_KeepsNoLimit() => Assert.False(new WorstCase().ToFigure("q", "", 1.0).IsKept);

    [Fact]
    public void Note_SeveralCases_KeepsTheWorstAndItsInput()
    {
        StressFigure figure = Noted((0.5, "first"), (2.0, "second"), (1.0, "third")).ToFigure("error", "m", 1.0);
        Assert.Equal(new StressFigure("error", "m", 2.0, 1.0, "second"), figure);
        Assert.False(figure.IsKept);
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(2.0)]
    public void Note_NotGreaterThanTheWorst_AsksForNoInput(double error)
    {
        WorstCase worst = Noted((2.0, "the greater"));
        worst.Note(error, () => throw new InvalidOperationException("asked"));
        Assert.Equal("the greater", worst.ToFigure("error", "m", 3.0).WorstInput);
    }

    [Fact]
    public void Note_NotANumber_StaysTheWorst()
    {
        StressFigure figure = Noted(
            (1e300, "large"), (double.NaN, "none"), (double.PositiveInfinity, "infinite")).ToFigure("q", "", double.PositiveInfinity);
        Assert.Equal("none", figure.WorstInput);
        Assert.False(figure.IsKept);
    }

    [Fact]
    public void Add_OfParts_KeepsTheWorstAndOfEqualsTheFirst()
    {
        WorstCase all = new();
        all.Add(new WorstCase());
        all.Add(Noted((1.0, "first")));
        all.Add(Noted((1.0, "second")));
        Assert.Equal("first", all.ToFigure("q", "", 1.0).WorstInput);
        all.Add(Noted((double.NaN, "none")));
        all.Add(Noted((5.0, "five")));
        Assert.Equal("none", all.ToFigure("q", "", 1.0).WorstInput);
    }

    private static WorstCase Noted(params (double Error, string Input)[] cases)
    {
        WorstCase worst = new();
        foreach ((double error, string input) in cases)
        {
            worst.Note(error, () => input);
        }

        return worst;
    }
}
