using Xunit;

namespace Msisf.Stress.Tests;

public sealed class WorstCaseTests
{
    [Fact]
    public void ToFigure_NoCase_KeepsNoLimit() => Assert.False(new WorstCase().ToFigure("q", "", 1.0).IsKept);

    [Fact]
    public void Take_LesserAfterGreater_TheGreaterStays()
    {
        WorstCase worst = With(2.0, "two");
        Assert.False(worst.IsBeatenBy(1.0));
        Assert.False(worst.IsBeatenBy(2.0));
        Assert.True(worst.IsBeatenBy(3.0));
        Assert.Equal("two", worst.ToFigure("q", "", 1.0).WorstInput);
    }

    [Fact]
    public void Take_NotANumber_StaysTheWorst()
    {
        Assert.True(With(1e300, "large").IsBeatenBy(double.NaN));
        WorstCase worst = With(double.NaN, "none");
        Assert.False(worst.IsBeatenBy(double.PositiveInfinity));
        Assert.False(worst.ToFigure("q", "", double.PositiveInfinity).IsKept);
    }

    [Fact]
    public void Add_OfParts_KeepsTheWorstAndOfEqualsTheFirst()
    {
        WorstCase all = new();
        all.Add(new WorstCase());
        all.Add(With(1.0, "first"));
        all.Add(With(1.0, "second"));
        Assert.Equal("first", all.ToFigure("q", "", 1.0).WorstInput);
        all.Add(With(double.NaN, "none"));
        all.Add(With(5.0, "five"));
        Assert.Equal("none", all.ToFigure("q", "", 1.0).WorstInput);
    }

    [Fact]
    public void Note_LesserError_KeepsTheGreaterAndAsksForNoInput()
    {
        WorstCase worst = new();
        worst.Note(2.0, () => "the greater");
        worst.Note(1.0, () => throw new InvalidOperationException("asked"));

        Assert.Equal(new StressFigure("error", "m", 2.0, 3.0, "the greater"), worst.ToFigure("error", "m", 3.0));
    }

    private static WorstCase With(double error, string input)
    {
        WorstCase worst = new();
        worst.Take(error, input);
        return worst;
    }
}
