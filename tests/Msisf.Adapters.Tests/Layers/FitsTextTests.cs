using Msisf.Adapters.Layers;
using Xunit;

namespace Msisf.Adapters.Tests.Layers;

public class FitsTextTests
{
    [Theory]
    [InlineData("--fov 40 {1,2} & \"x\"", "--fov 40 {1,2} & \"x\"")]
    [InlineData("'\u00e4'\t\\", "\\u0027\\u00e4\\u0027\\u0009\\u005c")]
    [InlineData("\U0001F315", "\\ud83c\\udf15")]
    public void Ascii_Text_HasOnlyWhatEveryReaderTakes(string text, string expected) => Assert.Equal(expected, FitsText.Ascii(text));

    [Fact]
    public void Wrap_LongText_BreaksAtBlanksAndFillsCards()
    {
        string text = string.Join(' ', Enumerable.Repeat("sevenxx", 25));

        string[] lines = [.. FitsText.Wrap(text)];

        Assert.Equal(text, string.Join(' ', lines));
        Assert.Equal([71, 71, 55], lines.Select(line => line.Length));
    }
}
