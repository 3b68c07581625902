using Msisf.Cli.Options.Config;
using Xunit;

namespace Msisf.Cli.Tests.Config;

public sealed class ConfigRulesTests
{
    /// <summary>What a command would refuse, were all of it on the command line.</summary>
    [Theory]
    [InlineData("ldem=moon.lbl", "source=mysql", "")]
    [InlineData("ldem=moon.lbl", "source=ldem", "ldem")]
    [InlineData("ignore-sun=true,aberration=lt", "", "ignore-sun")]
    [InlineData("ignore-sun=false,aberration=lt", "", "aberration,ignore-sun")]
    public void Applicable_SettingsThatExcludeEachOther_LeavesOneOut(string inFile, string onLine, string kept)
    {
        Dictionary<string, string> line = Pairs(onLine);
        Dictionary<string,
        ConfigValue> file = Pairs(inFile).ToDictionary(
            pair => pair.Key, pair => new ConfigValue(pair.Key, pair.Value, "a.yaml", 1, Rank: 1));

        Assert.Equal(
            kept, string.Join(',', ConfigRules.Applicable(file, line.GetValueOrDefault, draws: true).Keys.Order(StringComparer.Ordinal)));
    }

    private static Dictionary<string, string> Pairs(string text) =>
        text.Split(
            ',', StringSplitOptions.RemoveEmptyEntries).Select(pair => pair.Split('=')).ToDictionary(pair => pair[0], pair => pair[1]);
}
