using Msisf.Core.Render.Sampling;
using Msisf.Core.Render.Visibility;
using Xunit;

namespace Msisf.Core.Tests.Render.Sampling;

/// <summary>How samples are spread over classes of pixels.</summary>
public sealed class SampleBudgetTests
{
    private const int Trials = 10_000; // so many that what is expected without a measurement has no weight

    private const int Class = 5;

    /// <summary>Mean squared errors of the trials with 1, 8, 16, 32 and 64 samples: rms 2, 0.5, 0.25, 0.1 and 0 levels.</summary>
    private static readonly double[] Squares = [4.0, 0.25, 0.0625, 0.01, 0.0];

    [Theory]
    [InlineData(3.0, 0)]
    [InlineData(1.0, 1)]
    [InlineData(0.4, 2)]
    [InlineData(0.2, 4)]
    [InlineData(0.05, 8)]
    public void CodesOf_OneClass_AreAsFewSamplesAsTheErrorAllows(double error, int vectors)
    {
        ClassError[] errors = Errors();
        Measure(errors[Class], 1.0, merged: 0.0);

        byte code = SampleBudget.CodesOf(Histogram((Class, 1000)), errors, error)[Class];

        Assert.Equal(vectors, code & SampledPixels.Vectors);
        Assert.Equal(0, code & SampledPixels.HasBorder);
    }

    [Fact]
    public void CodesOf_AClassWithBordersOfShadows_GivesEachSampleItsLight()
    {
        ClassError[] errors = Errors();
        Measure(errors[Class], 1.0, merged: 1.0);

        byte code = SampleBudget.CodesOf(Histogram((Class, 1000)), errors, 0.4)[Class];

        Assert.NotEqual(0, code & SampledPixels.HasBorder);
    }

    [Theory]
    [InlineData(0.3, 0.4, true)] // rms by areas, error that is asked for
    [InlineData(0.3, 0.2, false)]
    public void CodesOf_KnownAreas_TakesThemWhereTheyAreGoodEnough(double byAreas, double error, bool isByAreas)
    {
        ClassError[] errors = Errors();
        Measure(errors[Class], 1.0, merged: 0.0);
        errors[Class].AreaSquares = byAreas * byAreas * Trials;

        byte code = SampleBudget.CodesOf(Histogram((Class, 1000)), errors, error)[Class];

        Assert.Equal(isByAreas, code == SampleBudget.Areas);
    }

    [Theory]
    [InlineData(0.05, 1)]
    [InlineData(0.4, 2)] // with one sample an error of 0.17 times the contrast is expected
    [InlineData(0.7, 3)] // in the class of contrasts of 3 and 4
    [InlineData(1.0, 5)]
    [InlineData(50.0, 65)] // in the last class
    public void MinContrast_AnError_IsTheLeastContrastOfTheClassThatIsExpectedToLeaveIt(double error, int expected) =>
        Assert.Equal(expected, SampleBudget.MinContrast(error));

    [Fact]
    public void CodesOf_TwoClasses_SpendMoreWhereMoreErrorIs()
    {
        ClassError[] errors = Errors();
        Measure(errors[Class], 1.0, merged: 0.0);
        Measure(errors[Class + 1], 25.0, merged: 0.0);

        byte[] codes = SampleBudget.CodesOf(Histogram((Class, 1000), (Class + 1, 1000)), errors, 1.0);

        Assert.True(codes[Class + 1] > codes[Class], $"{codes[Class]} and {codes[Class + 1]}");
    }

    [Fact]
    public void CodesOf_AnImageWithoutContrastOrError_AreNone() =>
        Assert.All(SampleBudget.CodesOf(Histogram((0, 1000)), Errors(), 0.05), code => Assert.Equal(0, code));

    private static ClassError[] Errors() => [.. Enumerable.Range(0, PixelClass.Count).Select(_ => new ClassError())];

    private static int[] Histogram(params (int Class, int Pixels)[] classes)
    {
        int[] histogram = new int[PixelClass.Count];
        foreach ((int index, int pixels) in classes)
        {
            histogram[index] = pixels;
        }

        return histogram;
    }

    private static void Measure(ClassError error, double factor, double merged)
    {
        error.Pixels = Trials;
        error.Parts = 2 * Trials;
        error.MergedSquares = merged * Trials;
        error.AreaSquares = factor * Squares[0] * Trials; // no better than one sample
        for (int i = 0; i < Squares.Length; i++)
        {
            error.Squares[i] = factor * Squares[i] * Trials;
        }
    }
}
