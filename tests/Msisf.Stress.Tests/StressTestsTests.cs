using Msisf.TestSupport;
using Xunit;

namespace Msisf.Stress.Tests;

/// <summary>The everyday length of each stress test.</summary>
public sealed class StressTestsTests
{
    public static TheoryData<string> Names => [.. StressTests.All.Where(test => test.MissingPart is null).Select(test => test.Name)];

    [Theory]
    [MemberData(nameof(Names))]
    public void Run_EverydayLength_KeepsAllLimits(string name)
    {
        StressLength length = TestLength.IsLong ? StressLength.Full : StressLength.Everyday;
        StressReport report = StressTests.All.Single(test => test.Name == name).Run(length, StressTests.Seed);
        Assert.True(report.Cases > 0);
        Assert.NotEmpty(report.Figures);
        Assert.All(report.Figures, figure => Assert.True(
            figure.IsKept, $"{figure.Quantity}: {figure.Worst:R} {figure.Unit}, at most {figure.Limit:R} allowed; {figure.WorstInput}"));
    }

    /// <summary>Those that can't run here must not pass as if they had.</summary>
    [MissingPartsFact]
    public void All_OnThisMachine_MissNoPart() =>
        Assert.All(StressTests.All, test => Assert.True(test.MissingPart is null, $"{test.Name} needs {test.MissingPart}"));

    [Fact]
    public void All_Names_AreFitForFilesAndDiffer()
    {
        Assert.All(StressTests.All, test => Assert.Matches("^[a-z][a-z0-9-]*$", test.Name));
        Assert.Equal(StressTests.All.Count, StressTests.All.Select(test => test.Name).Distinct().Count());
    }
}
