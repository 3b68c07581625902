using Msisf.App.Settings;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Settings;

public sealed class ReflectanceTextTests
{
    [Fact]
    public void Parse_LawWithParameters_IsInLowerCaseAndByName()
    {
        (string law, SortedDictionary<string, double> parameters) = ReflectanceText.Parse("Hapke: W = 0.3 ,b0=1.2");

        Assert.Equal("hapke", law);
        Assert.Equal([("b0", 1.2), ("w", 0.3)], parameters.Select(pair => (pair.Key, pair.Value)));
    }

    [Theory]
    [InlineData("hapke:w", "'w' is not a parameter; name=number is needed")]
    [InlineData("hapke:", "'' is not a parameter")]
    [InlineData("hapke:w=nan", "'w=nan' is not a parameter")]
    [InlineData("hapke:w=0.3,W=0.4", "the parameter w is given twice")]
    [InlineData("lambart", "'lambart' is not a law")]
    public void Parse_WrongText_SaysWhat(string text, string words) => Assert.Contains(
        words, Assert.Throws<UsageException>(() => ReflectanceText.Parse(text)).Message, StringComparison.Ordinal);
}
