using Msisf.TestSupport;
using Xunit;

namespace Msisf.Stress.Tests;

/// <summary>The everyday length of each stress test.</summary>
public sealed class StressTestsTests
{
    public static TheoryData<string> Names => [.. StressTests.All.Select(test => test.Name)];

    [Theory]
    [MemberData(nameof(Names))]
    public void Run_EverydayLength_KeepsAllLimits(string name)
    {
        StressLength length = TestLength.IsLong ? StressLength.Full : StressLength.Everyday;
        StressReport report = StressTests.All.Single(test => test.Name == name).Run(length, StressTests.Seed);
        Assert.True(report.Cases > 0);
        Assert.All(report.Figures, figure => Assert.True(
            figure.IsKept, $"{figure.Quantity}: {figure.Worst:R} {figure.Unit}, at most {figure.Limit:R} allowed; {figure.WorstInput}"));
    }
}
