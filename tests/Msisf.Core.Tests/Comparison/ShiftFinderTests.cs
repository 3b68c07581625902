using Msisf.Core.Comparison;
using Xunit;

namespace Msisf.Core.Tests.Comparison;

public sealed class ShiftFinderTests
{
    private const int Width = 90;

    private const int Height = 70;

    /// <summary>Transforms round to 1e-12 of the sums.</summary>
    private const double Tolerance = 1e-9;

    /// <summary>Each shift's correlation by its definition, over the pixels that both images have.</summary>
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(3.0, -5.0)]
    [InlineData(-7.3, 2.6)]
    public void Find_ImagesWithGaps_IsTheBestOfAllShiftsByDefinition(double right, double down)
    {
        float[] drawn = Image(0.0, 0.0);
        float[] real = Image(right, down);
        Random random = new(7);
        for (int i = 0; i < real.Length; i++)
        {
            real[i] = random.NextDouble() < 0.1 ? float.NaN : (100.0f * real[i]) + (float)random.NextDouble();
            drawn[i] = random.NextDouble() < 0.1 ? float.NaN : drawn[i];
        }

        (ImageShift? whole, IReadOnlyList<BlockShift> blocks) = new ShiftFinder(real, drawn, Width).Find(CancellationToken.None);

        Assert.NotNull(whole);
        Assert.Equal(right, whole.Value.Right, 0.15);
        Assert.Equal(down, whole.Value.Down, 0.15);
        Assert.Equal(BestByDefinition(real, drawn, (right, down), (0, 0, Width, Height)), whole.Value.Correlation, Tolerance);
        Assert.Equal(Correlation(real, drawn, 0, 0, (0, 0, Width, Height)), whole.Value.Unshifted, Tolerance);
        Assert.Equal([(0, 0, 64, 64), (64, 0, 26, 64), (0, 64, 64, 6), (64, 64, 26, 6)],
            blocks.Select(block => (block.Left, block.Top, block.Width, block.Height)));
        BlockShift first = blocks[0];
        Assert.Equal(BestByDefinition(real, drawn, (right, down), (0, 0, 64, 64)), first.Shift!.Value.Correlation, Tolerance);
        Assert.Equal(right, first.Shift!.Value.Right, 0.2);
        Assert.Equal(down, first.Shift!.Value.Down, 0.2);
    }

    [Fact]
    public void Find_OneGrey_HasNoShift()
    {
        float[] grey = new float[Width * Height];
        Array.Fill(grey, 0.3f);

        (ImageShift? whole, IReadOnlyList<BlockShift> blocks) = new ShiftFinder(grey, Image(0.0, 0.0), Width).Find(CancellationToken.None);

        Assert.Null(whole);
        Assert.All(blocks, block => Assert.Null(block.Shift));
    }

    [Fact]
    public void Find_NoPixels_HasNoShift()
    {
        float[] none = new float[Width * Height];
        Array.Fill(none, float.NaN);

        Assert.Null(new ShiftFinder(none, Image(0.0, 0.0), Width).Find(CancellationToken.None).Whole);
    }

    /// <summary>A shift at the end of what is looked at may not be the best one.</summary>
    [Fact]
    public void Find_BestAtTheEndOfTheReach_HasNoShift() => Assert.Null(
        new ShiftFinder(Image(ShiftFinder.Reach, 0.0), Image(0.0, 0.0), Width).Find(CancellationToken.None).Whole);

    /// <summary>Some waves, moved.</summary>
    private static float[] Image(double right, double down) => [.. Enumerable.Range(0, Width * Height).Select(i =>
    {
        (double x, double y) = ((i % Width) - right, (i / Width) - down);
        return (float)(
            Math.Sin(0.31 * x) + Math.Cos((0.23 * y) + (0.1 * x)) + Math.Sin((0.004 * x * x) - (0.4 * y)) + (0.5 * Math.Cos(0.6 * y)));
    })];

    /// <summary>Of the shifts about the true one, and of every fifth of all: more take seconds.</summary>
    private static double BestByDefinition(
        float[] real, float[] drawn, (double Right, double Down) shift, (int Left, int Top, int Width, int Height) block)
    {
        IEnumerable<(int Right, int Down)> near = Enumerable.Range(-1, 3).SelectMany(down => Enumerable.Range(-1, 3).Select(
            right => ((int)Math.Round(shift.Right) + right, (int)Math.Round(shift.Down) + down)));
        int[] steps = [.. Enumerable.Range(0, 7).Select(step => (5 * step) - 15)];
        return near.Concat(steps.SelectMany(down => steps.Select(right => (right, down))))
            .Max(((int Right, int Down) at) => Correlation(real, drawn, at.Right, at.Down, block));
    }

    private static double Correlation(
        float[] real, float[] drawn, int right, int down, (int Left, int Top, int Width, int Height) block)
    {
        List<(double R, double D)> pairs = [];
        for (int y = block.Top; y < block.Top + block.Height; y++)
        {
            for (int x = block.Left; x < block.Left + block.Width; x++)
            {
                (int fromX, int fromY) = (x - right, y - down);
                if (fromX >= 0 && fromX < Width && fromY >= 0 && fromY < Height && !float.IsNaN(real[(y * Width) + x])
                    && !float.IsNaN(drawn[(fromY * Width) + fromX]))
                {
                    pairs.Add((real[(y * Width) + x], drawn[(fromY * Width) + fromX]));
                }
            }
        }

        (double meanR, double meanD) = (pairs.Average(pair => pair.R), pairs.Average(pair => pair.D));
        return pairs.Sum(pair => (pair.R - meanR) * (pair.D - meanD)) / Math.Sqrt(
            pairs.Sum(pair => (pair.R - meanR) * (pair.R - meanR)) * pairs.Sum(pair => (pair.D - meanD) * (pair.D - meanD)));
    }
}
