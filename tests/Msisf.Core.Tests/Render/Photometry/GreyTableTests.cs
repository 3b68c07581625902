using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class GreyTableTests
{
    /// <summary>1, relative: the table's borders and the formula's are rounded by a few ulps each.</summary>
    private const double Rounding = 1e-14;

    [Theory]
    [InlineData(8, 1.0, GreyTransfer.Srgb)]
    [InlineData(8, 0.37, GreyTransfer.Srgb)]
    [InlineData(8, 2.5, GreyTransfer.Linear)]
    [InlineData(16, 1.0, GreyTransfer.Srgb)]
    [InlineData(16, 0.37, GreyTransfer.Linear)]
    public void Convert_BothSidesOfEveryBorder_IsTheFormulasLevel(int bitDepth, double exposure, GreyTransfer transfer)
    {
        GreyScale scale = new(exposure, transfer);
        int max = (1 << bitDepth) - 1;
        double[] borders = [.. Enumerable.Range(1, max).Select(level => Border(scale, level, max))];

        int[] below = Convert(scale, bitDepth, [.. borders.Select(border => border * (1.0 - Rounding))]);
        int[] above = Convert(scale, bitDepth, [.. borders.Select(border => border * (1.0 + Rounding))]);

        Assert.Equal(Enumerable.Range(0, max), below);
        Assert.Equal(Enumerable.Range(1, max), above);
    }

    [Theory]
    [InlineData(8)]
    [InlineData(16)]
    public void Convert_EvenSteps_IsTheFormulasLevel(int bitDepth)
    {
        // 0.00000137 meets no border to 14 digits, and is far finer than the levels.
        GreyScale scale = new(1.7);
        double[] radianceFactors = [.. Enumerable.Range(0, 500_000).Select(i => i * 0.00000137)];

        Assert.Equal(radianceFactors.Select(factor => scale.Level(factor, (1 << bitDepth) - 1)), Convert(scale, bitDepth, radianceFactors));
    }

    [Theory]
    [InlineData(8, 255)]
    [InlineData(16, 65535)]
    public void Convert_BeyondTheEnds_IsBlackAndWhite(int bitDepth, int white) =>
        Assert.Equal(
            [0, 0, 0, 0, white, white, white],
            Convert(new GreyScale(), bitDepth, [double.NegativeInfinity, -1.0, -0.0, 0.0, 1.0, 1e300, double.PositiveInfinity]));

    /// <summary>Eight at once are converted in another way than one alone.</summary>
    [Theory]
    [InlineData(1.0, GreyTransfer.Srgb)]
    [InlineData(0.37, GreyTransfer.Srgb)]
    [InlineData(2.5, GreyTransfer.Linear)]
    public void Convert_ManyAtOnce_IsWhatEachGivesAlone(double exposure, GreyTransfer transfer)
    {
        GreyScale scale = new(exposure, transfer);
        GreyTable table = new(scale, 8);
        Random random = new(20260923);
        double[] radianceFactors =
        [
            .. Enumerable.Range(1, 255).Select(level => Border(scale, level, 255)).SelectMany(AllAround),
            .. Enumerable.Range(0, 4097).Select(step => step / (4096.0 * exposure)).SelectMany(AllAround),
            .. Enumerable.Range(0, 100_003).Select(_ => (random.NextDouble() * 1.1 / exposure) - 0.01),
            double.NegativeInfinity, -1e300, -0.0, 1e300, double.PositiveInfinity,
        ];

        byte[] alone = new byte[radianceFactors.Length];
        for (int i = 0; i < alone.Length; i++)
        {
            table.Convert(radianceFactors.AsSpan(i, 1), alone.AsSpan(i, 1));
        }

        Assert.Equal(alone.Select(level => (int)level), Convert(scale, 8, radianceFactors));

        // The number and its twelve neighbours: the table's borders are that close to the formula's.
        static IEnumerable<double> AllAround(double number) =>
            Enumerable.Range(-6, 13).Select(ulps => BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(number) + ulps))
                .Where(double.IsFinite);
    }

    /// <summary>By bisection: the minimum radiance factor to which the plain formula gives the level.</summary>
    private static double Border(GreyScale scale, int level, int max)
    {
        double below = 0.0;
        double above = 1.0 / scale.Exposure;
        for (double middle = 0.5 * above; below < middle && middle < above; middle = 0.5 * (below + above))
        {
            (below, above) = scale.Level(middle, max) >= level ? (below, middle) : (middle, above);
        }

        return above;
    }

    private static int[] Convert(GreyScale scale, int bitDepth, double[] radianceFactors)
    {
        GreyTable table = new(scale, bitDepth);
        if (bitDepth == 8)
        {
            byte[] bytes = new byte[radianceFactors.Length];
            table.Convert(radianceFactors, bytes);
            return [.. bytes];
        }

        ushort[] words = new ushort[radianceFactors.Length];
        table.Convert(radianceFactors, words);
        return [.. words];
    }
}
