using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Settings.Specs;

/// <summary>Where an option came from decides the exit code of its error, and what the message says.</summary>
public sealed class OptionValuesTests
{
    private static readonly TextSpec Typed = new("--typed", OptionRole.HowItRuns, "TEXT", "On the command line");

    private static readonly TextSpec Filed = new("--filed", OptionRole.HowItRuns, "TEXT", "In a file");

    private static readonly OptionValues Values = new(
    [
        KeyValuePair.Create("--typed", new OptionValue(["a", "b"])),
        KeyValuePair.Create("--filed", new OptionValue(["c"], "run.yaml, line 3")),
    ]);

    [Fact]
    public void IsGiven_OptionOfAFile_IsSetButNotGiven()
    {
        Assert.True(Values.IsGiven(Typed));
        Assert.Equal("a b", Values.Text(Typed));
        Assert.False(Values.IsGiven(Filed));
        Assert.Equal("c", Values.Text(Filed));
    }

    [Fact]
    public void ErrorOfAnOptionOfAFile_IsThatOfItsContentAndNamesTheLine()
    {
        UsageException failure = new UsageException("It is wrong.").About(Filed);

        Assert.Equal(2, Values.ExitCodeOf(failure));
        Assert.Equal("It is wrong. --filed comes from run.yaml, line 3.", Values.MessageOf(failure));
    }

    [Fact]
    public void ErrorOfOptionsOfBoth_IsAWrongCommandLine()
    {
        UsageException failure = new UsageException("They contradict each other.").About(Typed, Filed);

        Assert.Equal(1, Values.ExitCodeOf(failure));
        Assert.Equal("They contradict each other. --filed comes from run.yaml, line 3.", Values.MessageOf(failure));
        Assert.Equal(1, Values.ExitCodeOf(new UsageException("It is of none.")));
    }
}
