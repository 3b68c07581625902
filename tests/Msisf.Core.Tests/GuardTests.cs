using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Core.Tests;

public sealed class GuardTests
{
    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(double.NegativeInfinity)]
    public void Finite_NotFinite_IsRefusedByName(double value) =>
        Assert.StartsWith(
            "a (m) is ", Assert.Throws<BadInputException>(() => Guard.Finite(value, "a (m)")).Message, StringComparison.Ordinal);

    [Fact]
    public void Finite_Number_Passes() => Assert.Equal(-1.5, Guard.Finite(-1.5, "a"));

    [Theory]
    [InlineData(0.0)]
    [InlineData(-1.0)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void Positive_ZeroOrLess_IsRefused(double value) =>
        Assert.Throws<BadInputException>(() => Guard.Positive(value, "a"));

    [Theory]
    [InlineData(0.9)]
    [InlineData(2.1)]
    [InlineData(double.NaN)]
    public void InRange_Outside_IsRefusedWithTheRange(double value) =>
        Assert.Contains(
            "from 1 to 2", Assert.Throws<BadInputException>(() => Guard.InRange(value, 1.0, 2.0, "a")).Message, StringComparison.Ordinal);

    [Theory]
    [InlineData(1.0)]
    [InlineData(2.0)]
    public void InRange_Borders_Pass(double value) => Assert.Equal(value, Guard.InRange(value, 1.0, 2.0, "a"));
}
