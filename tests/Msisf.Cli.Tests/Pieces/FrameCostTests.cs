using System.Globalization;
using Msisf.Cli.Pieces;
using Msisf.Core.Render;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary>The estimate against measured times (docs/scaling.md says how they were measured).</summary>
public sealed class FrameCostTests
{
    /// <summary>The correlations were 0.82 and 0.96; times of a busy machine have little more in common with themselves, measured twice.</summary>
    [Theory]
    [InlineData("native-64", RendererKind.Native, 512, 0.8)]
    [InlineData("povray-16", RendererKind.PovRay, 320, 0.9)]
    public void Seconds_MeasuredFrames_CorrelateWithTheirTimes(string series, RendererKind renderer, int side, double min)
    {
        FrameCost cost = FrameCost.Of(renderer);
        (double Time, double Estimate)[] frames =
        [
            .. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "docs", "benchmark", "frame-times.csv"))
                .Select(line => line.Split(','))
                .Where(fields => fields[0] == series)
                .Select(fields => (
                    double.Parse(fields[2], CultureInfo.InvariantCulture),
                    cost.Seconds(side * side, long.Parse(fields[3], CultureInfo.InvariantCulture)))),
        ];

        Assert.True(frames.Length > 30, $"{frames.Length} frames of {series}");
        Assert.InRange(Correlation(frames), min, 1.0);
    }

    private static double Correlation((double X, double Y)[] pairs)
    {
        double meanX = pairs.Average(pair => pair.X);
        double meanY = pairs.Average(pair => pair.Y);
        double Sum(Func<double, double, double> product) => pairs.Sum(pair => product(pair.X - meanX, pair.Y - meanY));
        return Sum((x, y) => x * y) / Math.Sqrt(Sum((x, _) => x * x) * Sum((_, y) => y * y));
    }
}
