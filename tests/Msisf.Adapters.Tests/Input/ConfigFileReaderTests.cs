using System.Text;
using Msisf.Adapters.Input;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public sealed class ConfigFileReaderTests
{
    [Fact]
    public void Read_Entries_KeepOrderTextAndPlace()
    {
        IReadOnlyList<ConfigEntry> entries = Read(
            "# settings\nfov: 40\n\noutput-dir: \"a b\" # where\nlayers: [depth, mask]\npov-options:\n  - -A\n  - +Q9\n");

        Assert.Equal(["fov", "output-dir", "layers", "pov-options"], entries.Select(entry => entry.Key));
        Assert.Equal(["40"], entries[0].Values);
        Assert.Equal(["a b"], entries[1].Values);
        Assert.Equal(["depth", "mask"], entries[2].Values);
        Assert.Equal(["-A", "+Q9"], entries[3].Values);
        Assert.Equal([false, false, true, true], entries.Select(entry => entry.IsList));
        Assert.Equal([(2, 1), (4, 1), (5, 1), (6, 1)], entries.Select(entry => (entry.Line, entry.Column)));
    }

    [Theory]
    [InlineData("fov: 40\r\nres: 4\r\n")]
    [InlineData("fov: 40\nres: 4")]
    [InlineData("\uFEFFfov: 40\nres: 4\n")]
    [InlineData("---\nfov: 40\nres: 4\n...\n")]
    [InlineData("%YAML 1.2\n---\nfov: 40\nres: 4\n")]
    [InlineData("{fov: 40, res: 4}")]
    [InlineData("'fov': '40'\n\"res\": \"4\"\n")]
    public void Read_FormsOfTheSameSettings_AreTheSame(string text) =>
        Assert.Equal([("fov", "40"), ("res", "4")], Read(text).Select(entry => (entry.Key, entry.Values[0])));

    [Theory]
    [InlineData("fov: 040", "040")]
    [InlineData("fov: 1e3", "1e3")]
    [InlineData("fov: yes", "yes")]
    [InlineData("fov: 2026-01-01", "2026-01-01")]
    [InlineData("fov: \"\"", "")]
    [InlineData("fov: \"null\"", "null")]
    [InlineData("fov: >-\n  two\n  lines\n", "two lines")]
    public void Read_Value_StaysText(string text, string value) => Assert.Equal([value], Assert.Single(Read(text)).Values);

    [Theory]
    [InlineData("")]
    [InlineData("\n\n# nothing\n")]
    [InlineData("---\n")]
    [InlineData("\uFEFF")]
    [InlineData("null")]
    public void Read_NothingInIt_HasNoEntries(string text) => Assert.Empty(Read(text));

    [Theory]
    [InlineData("fov: 40\nfov: 41\n", "line 2, column 1", "'fov' is there already, in line 1")]
    [InlineData("fov: &a 40\n", "line 1, column 6", "anchors and tags are not read here")]
    [InlineData("fov: &a 40\nres: *a\n", "line 1, column 6", "anchors")]
    [InlineData("fov: 40\nres: *a\n", "line 2, column 6", "aliases are not read here")]
    [InlineData("res: [*a]\n", "line 1, column 7", "aliases")]
    [InlineData("fov: !!str 40\n", "line 1, column 6", "anchors and tags")]
    [InlineData("&a fov: 40\n", "line 1, column 1", "anchors")]
    [InlineData("fov:\n", "line 1, column 5", "'fov' has no value")]
    [InlineData("fov: ~\n", "line 1, column 6", "'fov' has no value")]
    [InlineData("layers: [depth, null]\n", "line 1, column 17", "'layers' has no value")]
    [InlineData("layers: []\n", "line 1, column 9", "the list of 'layers' is empty")]
    [InlineData("fov:\n  res: 4\n", "line 2, column 3", "'fov' takes a value, or a list of values")]
    [InlineData("layers: [[depth]]\n", "line 1, column 10", "the list of 'layers' holds single values only")]
    [InlineData("[a]: 4\n", "line 1, column 1", "a key is a single word")]
    [InlineData("- fov\n", "line 1, column 1", "'key: value'")]
    [InlineData("fov 40\n", "line 1, column 1", "'key: value'")]
    [InlineData("fov: 40\n---\nres: 4\n", "line 2, column 1", "second YAML document")]
    [InlineData("fov: \"a\\0b\"\n", "line 1, column 6", "not one line of text")]
    [InlineData("fov: |\n  a\n  b\n", "line 1, column 6", "not one line of text")]
    [InlineData("fov: \"\\uD800\"\n", "line 1", "")]
    [InlineData("fov: \"\\U00110000\"\n", "line 1", "")]
    [InlineData("res: 4\n\tfov: 40\n", "line 1, column 6", "not YAML")] // where the value is that the tab goes on with
    [InlineData("fov:\n\t- 40\n", "line ", "not YAML")]
    [InlineData("fov: \"40\n", "line 1, column 6", "not YAML")]
    [InlineData("fov: [40\n", "line 2, column 1", "not YAML")]
    [InlineData("fov: 40: 5\n", "line 1, column 8", "not YAML")]
    [InlineData("fov: a\0b\n", "line 1, column 7", "control character")]
    public void Read_WrongFile_IsRefusedWithItsPlace(string text, string place, string message)
    {
        BadInputException error = Assert.Throws<BadInputException>(() => Read(text));

        Assert.StartsWith($"a.yaml, {place}", error.Message, StringComparison.Ordinal);
        Assert.Contains(message, error.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', error.Message);
    }

    /// <summary>Found by the fuzzer: YamlDotNet's own scanner fails on them.</summary>
    [Theory]
    [InlineData("fov: 40\nlayers: [depth, mask\nres: 4\n", 15)]
    [InlineData("fov: 40\nlayers: [de\r\npth]\n", 9)]
    [InlineData("fov: 40\nlayers: [de{a\nb, c]\n", 9)]
    public void Read_ListThatGoesOnInTheNextLine_IsRefused(string text, int column)
    {
        BadInputException error = Assert.Throws<BadInputException>(() => Read(text));

        Assert.StartsWith($"a.yaml, line 2, column {column}: this is not YAML", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_NotUtf8_NamesTheByte()
    {
        using MemoryStream stream = new([.. "fov: "u8, 0xE4, .. "\n"u8]);

        Assert.Contains(
            "byte 6 is not UTF-8",
            Assert.Throws<BadInputException>(() => ConfigFileReader.Read(stream, "a.yaml")).Message,
            StringComparison.Ordinal);
    }

    /// <summary>The stream could go on for ever.</summary>
    [Fact]
    public void Read_HugeFile_IsRefusedWithoutReadingItAll()
    {
        using MemoryStream stream = new(new byte[3 * ConfigFileReader.LargestSize]);

        Assert.Contains(
            "more than 1000000 bytes",
            Assert.Throws<BadInputException>(() => ConfigFileReader.Read(stream, "a.yaml")).Message,
            StringComparison.Ordinal);
        Assert.Equal(ConfigFileReader.LargestSize + 1, stream.Position);
    }

    [Theory]
    [InlineData("fov: 4\n", "fov: 4\n", 1)]
    [InlineData("fov: ", "[", ConfigFileReader.LargestSize / 2)]
    [InlineData("", "- ", ConfigFileReader.LargestSize / 2 - 1)]
    [InlineData("", "? ", 30_000)]
    [InlineData("a: ", "{a: ", 15_000)]
    public void Read_DeepNesting_IsRefusedAtOnce(string start, string repeated, int times) =>
        Assert.Throws<BadInputException>(() => Read(start + string.Concat(Enumerable.Repeat(repeated, times))));

    [Fact]
    public void Read_LargestFile_IsRead()
    {
        string line = "# " + new string('x', 997) + "\n";

        Assert.Equal("fov", Assert.Single(Read(string.Concat(Enumerable.Repeat(line, 999)) + "fov: 40\n")).Key);
    }

    private static IReadOnlyList<ConfigEntry> Read(string text)
    {
        using MemoryStream stream = new(Encoding.UTF8.GetBytes(text));
        return ConfigFileReader.Read(stream, "a.yaml");
    }
}
