using System.Globalization;
using Msisf.App.DataSets;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.DataSets;

public class DistributionTests
{
    /// <summary>
    /// python3 -c "from scipy.stats import truncnorm, loguniform; print(truncnorm((5-30)/15, (80-30)/15, 30, 15).ppf([.01, .5, .9]),
    /// loguniform(2e4, 2e5).ppf([.01, .5, .9]))".
    /// </summary>
    [Theory]
    [InlineData("normal 30 15 5 80", 0.01, 6.333310198205144)]
    [InlineData("normal 30 15 5 80", 0.5, 30.890902163078632)]
    [InlineData("normal 30 15 5 80", 0.9, 49.60493257297037)]
    [InlineData("log-uniform 2e4 2e5", 0.01, 20465.859845615083)]
    [InlineData("log-uniform 2e4 2e5", 0.5, 63245.553203367585)]
    [InlineData("log-uniform 2e4 2e5", 0.9, 158865.64694485633)]
    [InlineData("uniform -3 5", 0.25, -1.0)]
    [InlineData("7", 0.25, 7.0)]
    public void Quantile_OfEachKind_IsThatOfScipy(string text, double part, double expected)
    {
        Distribution distribution = Parse(text);

        Assert.Equal(expected, distribution.Quantile(part), 1e-8 * Math.Max(1.0, Math.Abs(expected)));
        Assert.Equal(distribution.Max, distribution.Quantile(1.0), Rounding.OfPlaces * Math.Abs(distribution.Max));
        Assert.True(text == "7" || Math.Abs(distribution.PartBelow(expected) - part) < 1e-8);
    }

    [Fact]
    public void Parse_ListOfTwo_IsUniform() => Assert.Equal("uniform 1 2", Distribution.Parse(["1", "2"], Number).ToString());

    [Theory]
    [InlineData("uniform 1", "is not a distribution; a number, [MIN, MAX]")]
    [InlineData("gauss 1 2", "is not a number")]
    [InlineData("uniform 5 1", "the first limit is not below the second")]
    [InlineData("log-uniform 0 1", "needs numbers above 0")]
    [InlineData("normal 1 0 0 2", "needs a standard deviation above 0")]
    [InlineData("normal 0 1 50 60", "nothing is left")]
    public void Parse_Nonsense_SaysWhy(string text, string why) =>
        Assert.Contains(why, Assert.Throws<BadInputException>(() => Parse(text)).Message, StringComparison.Ordinal);

    private static Distribution Parse(string text) => Distribution.Parse([text], Number);

    private static double Number(string text) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
        ? number
        : throw new BadInputException($"'{text}' is not a number");
}
