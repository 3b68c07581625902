using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Preparation;

public sealed class FrameNamingTests
{
    private static readonly Instant Time = Moments.OfMjd(55289.25);

    [Theory]
    [InlineData(OutputOptions.DefaultName, 7, "MoonSurfIllumSim_step_00007")]
    [InlineData(OutputOptions.DefaultName, 123456, "MoonSurfIllumSim_step_123456")]
    [InlineData("a{step}b", 7, "a7b")]
    [InlineData("{mjd}", 7, "55289.25")]
    [InlineData("t{mjd:0.000}_{step:000}", 7, "t55289.250_007")]
    [InlineData("plain", 7, "plain")]
    public void NameOf_Pattern_FillsTheFields(string pattern, int step, string expected) =>
        Assert.Equal(expected, new FrameNaming(pattern).NameOf(step, Time.Mjd));

    [Theory]
    [InlineData("")]
    [InlineData(" ")]
    [InlineData("a/b")]
    [InlineData("..")]
    [InlineData("{day}")]
    [InlineData("{step:x}")]
    [InlineData("{step")]
    [InlineData("step}")]
    [InlineData("a\nb")]
    public void Constructor_PatternThatIsNoFileName_IsRefused(string pattern) =>
        Assert.Throws<UsageException>(() => new FrameNaming(pattern));

    [Fact]
    public void NamesOf_TwoStatesOfOneName_NamesBothSteps()
    {
        UsageException exception = Assert.Throws<UsageException>(() => new FrameNaming("a{mjd:0}").NamesOf([Time, Time]));

        Assert.Contains("steps 1 and 2", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void NamesOf_StepInThePattern_TellsStatesOfOneTimeApart() =>
        Assert.Equal(["s1", "s2"], new FrameNaming("s{step}").NamesOf([Time, Time]));

    [Fact]
    public void NameOf_VeryLongName_IsRefused() =>
        Assert.Throws<UsageException>(() => new FrameNaming(new string('a', 200)));
}
