using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Pds;

public class PdsLabelParserTests
{
    [Fact]
    public void Parse_NestedObjects_FindsEachValueWhereItStands()
    {
        PdsObject label = Parse(
            "A = 1\r\nOBJECT = OUTER\r\n A = 2\r\n GROUP = INNER\r\n  A = 3 <km>\r\n END_GROUP = INNER\r\nEND_OBJECT\r\nEND\r\n");

        Assert.Equal("1", label.RequiredText("A"));
        Assert.Equal("2", label.FindObject("OUTER")!.RequiredText("A"));
        Assert.Equal(new PdsValue("3", IsQuoted: false, "km", Items: null, Line: 6), label.FindObject("INNER")!.Find("A"));
    }

    [Fact]
    public void Parse_TextsSetsAndCommentsOverLines_KeepsThemWhole()
    {
        PdsObject label = Parse(
            "T = \"a = 1\n   b /* no comment */\"\nS = {\"x,\n y\", 'z'} /* comment = 4 \n still */ Q = (1, (2, 3))\nEND\n");

        Assert.Equal("a = 1 b /* no comment */", label.RequiredText("T"));
        Assert.Equal("(x, y, z)", label.Required("S").ToString());
        Assert.Equal(2, label.Required("S").Items!.Count);
        Assert.Equal("(1, (2, 3))", label.Required("Q").ToString());
        Assert.Equal(6, label.Required("Q").Line);
    }

    [Fact]
    public void Parse_BinaryAfterEnd_IsNotLookedAt()
    {
        PdsObject label = Parse("A = 1\nEND\r\n\0\0\"<(\u00ff");

        Assert.Equal("1", label.RequiredText("A"));
    }

    [Fact]
    public void Parse_SameKeywordAndValueTwice_IsFine() => Assert.Equal("1", Parse("A = 1\nA = 1\nEND\n").RequiredText("A"));

    /// <summary>Of a keyword that is there twice only who needs it is told.</summary>
    [Fact]
    public void Find_KeywordTwiceWithOtherValues_IsRefusedWhereItIsNeeded()
    {
        PdsObject label = Parse("A = 1\nA = 2\nB = 3\nEND\n");

        Assert.Equal("3", label.RequiredText("B"));
        Assert.DoesNotContain(label.Values, pair => pair.Key == "A");
        Assert.Equal(
            "x.lbl, line 3: A = 2; line 2 of the same object says 1.",
            Assert.Throws<BadInputException>(() => label.RequiredText("A")).Message);
    }

    /// <summary>Spellings that labels have for a word of the standard.</summary>
    [Theory]
    [InlineData("BAND_SEQUENTIAL")]
    [InlineData("\"BAND SEQUENTIAL\"")]
    [InlineData("\"Band  Sequential\"")]
    [InlineData("'band-sequential'")]
    [InlineData("\"BAND_\n   SEQUENTIAL\"")]
    public void Word_OfSpellings_IsTheStandards(string text) =>
        Assert.Equal("BAND_SEQUENTIAL", Parse($"A = {text}\nEND\n").Required("A").Word);

    [Theory]
    [InlineData("A = 1\n", "line 3: the label ends; a keyword is needed")]
    [InlineData("A 1\nEND\n", "line 2: '1'; '=' after A is needed")]
    [InlineData("A = \"x\nEND\n", "line 2: the quotation that begins here has no end")]
    [InlineData("/* x\nEND\n", "line 2: the comment that begins here has no end")]
    [InlineData("A = 1 <km\nEND\n", "line 2: the unit that begins here has no end")]
    [InlineData("A = (1, 2\nEND\n", "line 3: 'END'; ',' or ')' is needed")]
    [InlineData("A = )\nEND\n", "line 2: ')'; a value is needed")]
    [InlineData("OBJECT = X\nEND\n", "line 3: 'END'; END_OBJECT = X is needed first (line 2 opens it)")]
    [InlineData("OBJECT = X\nEND_OBJECT = Y\nEND\n", "line 3: 'Y'; END_OBJECT = X is needed first")]
    [InlineData("END_OBJECT = X\nEND\n", "line 2: 'END_OBJECT'; no object is open here")]
    public void Parse_BrokenLabel_NamesFileAndLine(string text, string expected)
    {
        BadInputException exception = Assert.Throws<BadInputException>(() => Parse(text));

        Assert.StartsWith("x.lbl, " + expected, exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("\u0001\u0002\u0003")]
    [InlineData("A = 1\nEND\n")]
    public void Parse_NoLabel_SaysSo(string text) =>
        Assert.Contains(
            "not a PDS3 label",
            Assert.Throws<BadInputException>(() => PdsLabelParser.Parse(text, "x.lbl")).Message,
            StringComparison.Ordinal);

    private static PdsObject Parse(string text) => PdsLabelParser.Parse("PDS_VERSION_ID = PDS3\n" + text, "x.lbl");
}
