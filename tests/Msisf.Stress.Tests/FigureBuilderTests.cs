using Xunit;

namespace Msisf.Stress.Tests;

public sealed class FigureBuilderTests
{
    [Fact]
    public void Add_SeveralCases_KeepsTheWorstAndItsInput()
    {
        FigureBuilder figure = new("error", "m", 1.0);
        figure.Add(0.5, () => "first");
        figure.Add(2.0, () => "second");
        figure.Add(1.0, () => "third");

        Assert.Equal(new StressFigure("error", "m", 2.0, 1.0, "second"), figure.ToFigure());
        Assert.False(figure.ToFigure().IsKept);
    }

    [Fact]
    public void Add_NaN_StaysTheWorst()
    {
        FigureBuilder figure = new("error", "m", 1.0);
        figure.Add(double.NaN, () => "undefined");
        figure.Add(2.0, () => "later");

        Assert.Equal("undefined", figure.ToFigure().WorstInput);
        Assert.False(figure.ToFigure().IsKept);
    }

    [Fact]
    public void Add_OtherBuilder_TakesTheWorseErrorAndTheSumOfCounts()
    {
        FigureBuilder error = new("error", "m", 1.0);
        FigureBuilder otherError = new("error", "m", 1.0);
        FigureBuilder count = new("wrong", string.Empty, 0.0);
        FigureBuilder otherCount = new("wrong", string.Empty, 0.0);
        error.Add(0.5, () => "a");
        otherError.Add(0.7, () => "b");
        count.Count(() => "c");
        otherCount.Count(() => "d");
        otherCount.Count(() => "e");
        error.Add(otherError);
        count.Add(otherCount);

        Assert.Equal(new StressFigure("error", "m", 0.7, 1.0, "b"), error.ToFigure());
        Assert.Equal(new StressFigure("wrong", string.Empty, 3.0, 0.0, "c"), count.ToFigure());
    }
}
