using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Settings.Specs;

/// <summary>Options that are numbers: their ranges, borders included or not, and their messages.</summary>
public sealed class NumberSpecTests
{
    private static readonly NumberSpec Angle = new("--angle", OptionRole.HowItRuns, "DEGREES", "An angle")
    {
        Limits = new NumberRange(0.0, 180.0) { ExcludesMin = true, ExcludesMax = true },
        Default = 40.0,
    };

    private static readonly NumberSpec Share = new("--share", OptionRole.HowItRuns, "PART", "A part")
    {
        Limits = new NumberRange(0.0, 1.0),
    };

    private static readonly WholeNumberSpec Count = new("--count", OptionRole.HowItRuns, "N", 1, 16, "A count") { Default = 4 };

    [Theory]
    [InlineData("1e-3", 1e-3)]
    [InlineData("179.9", 179.9)]
    [InlineData(null, 40.0)]
    public void Read_NumberOfTheRangeOrNone_IsItOrTheDefault(string? text, double expected) =>
        Assert.Equal(expected, Angle.Read(Values(Angle, text)));

    [Theory]
    [InlineData("0", "--angle is 0; its range is above 0, below 180.")]
    [InlineData("180", "--angle is 180; its range is above 0, below 180.")]
    [InlineData("-1", "--angle is -1; its range is above 0, below 180.")]
    public void Read_NumberOnTheBorderOrBeyond_IsRefusedWithTheRange(string text, string message) =>
        Assert.Equal(message, Assert.Throws<UsageException>(() => Angle.Read(Values(Angle, text))).Message);

    [Theory]
    [InlineData("0", 0.0)]
    [InlineData("1", 1.0)]
    public void Read_BorderThatBelongsToTheRange_IsTaken(string text, double expected) =>
        Assert.Equal(expected, Share.ReadIfGiven(Values(Share, text)));

    [Theory]
    [InlineData("nan")]
    [InlineData("inf")]
    [InlineData("1,5")] // the tests run with a comma as the decimal sign
    [InlineData("")]
    public void Read_NoFiniteNumber_IsRefused(string text) =>
        Assert.StartsWith("--share: ", Assert.Throws<UsageException>(() => Share.ReadIfGiven(Values(Share, text))).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData("1", 1)]
    [InlineData("+16", 16)]
    [InlineData(null, 4)]
    public void Read_WholeNumber_IsItOrTheDefault(string? text, int expected) => Assert.Equal(expected, Count.Read(Values(Count, text)));

    [Theory]
    [InlineData("0")]
    [InlineData("17")]
    [InlineData("2.0")]
    [InlineData("99999999999")]
    public void Read_NoWholeNumberOfTheRange_IsRefusedWithTheRange(string text) => Assert.Equal(
        $"--count is '{text}'; a whole number from 1 to 16 is needed.",
        Assert.Throws<UsageException>(() => Count.Read(Values(Count, text))).Message);

    private static OptionValues Values(OptionSpec option, string? text) =>
        new(text is null ? [] : [KeyValuePair.Create(option.Name, new OptionValue([text]))]);
}
