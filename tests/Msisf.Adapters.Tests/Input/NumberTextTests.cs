using Msisf.Adapters.Input;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public class NumberTextTests
{
    [Theory]
    [InlineData("55289", 55289.0)]
    [InlineData("+2.00000E+006", 2e6)]
    [InlineData("5.5289E4", 55289.0)]
    [InlineData("-2.39117e-001", -0.239117)]
    [InlineData("+0.0E+0", 0.0)]
    [InlineData("2E6", 2e6)]
    [InlineData(".5", 0.5)]
    [InlineData("5.", 5.0)]
    [InlineData("1737400.123456789", 1737400.123456789)]
    [InlineData("1e-400", 0.0)]
    public void TryParse_ThesisNotation_NearestDouble(string text, double expected)
    {
        Assert.True(NumberText.TryParse(text, out double value));
        Assert.Equal(expected, value);
    }

    [Theory]
    [InlineData("", "a number is missing")]
    [InlineData(" ", "a number is missing")]
    [InlineData("abc", "'abc' is not a number; write decimal or scientific notation with a decimal point, e.g. -1737400.5 or +1.7374E+006")]
    [InlineData("1 ", "'1 ' is not a number")]
    [InlineData("1.2.3", "'1.2.3' is not a number")]
    [InlineData("1e", "'1e' is not a number")]
    [InlineData("--1", "'--1' is not a number")]
    [InlineData("1'000", "'1'000' is not a number")]
    [InlineData("1\0", "'1?' is not a number")]
    [InlineData("\u0661", "'\u0661' is not a number")]
    [InlineData("0x1F", "'0x1F' is hexadecimal")]
    [InlineData("-0X1F", "'-0X1F' is hexadecimal")]
    [InlineData("NaN", "'NaN' is not finite")]
    [InlineData("-Infinity", "'-Infinity' is not finite")]
    [InlineData("inf", "'inf' is not finite")]
    [InlineData("\u221E", "'\u221E' is not finite")]
    [InlineData("information", "'information' is not a number")]
    [InlineData("1,5", "'1,5' has a comma; numbers have a decimal point and no thousands separators")]
    [InlineData("1,737,400.5", "'1,737,400.5' has a comma")]
    [InlineData("\u22125", "'\u22125' has a typographic minus sign; write '-'")]
    [InlineData("1e999", "'1e999' is too large; numbers reach up to 1.797E+308")]
    [InlineData("-1e309", "'-1e309' is too large")]
    public void ProblemWith_NoNumber_SaysWhy(string text, string problem)
    {
        Assert.False(NumberText.TryParse(text, out _));
        Assert.StartsWith(problem, NumberText.ProblemWith(text), StringComparison.Ordinal);
    }

    [Fact]
    public void ProblemWith_EnormousText_ShowsItsStart() =>
        Assert.StartsWith(
            $"'{new string('z', 40)}...' is not a number", NumberText.ProblemWith(new string('z', 1_000_000)), StringComparison.Ordinal);
}
