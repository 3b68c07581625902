using Msisf.App.Settings;
using Msisf.App.Settings.Config;
using Xunit;

namespace Msisf.App.Tests.Settings.Config;

public sealed class ConfigRulesTests
{
    /// <summary>What a run would refuse, were all of it on the command line.</summary>
    [Theory]
    [InlineData("ignore-sun=true,aberration=lt", "", "--ignore-sun")]
    [InlineData("ignore-sun=false,aberration=lt", "", "--aberration,--ignore-sun")]
    [InlineData("lod=off,lod-error=1", "", "--lod")]
    [InlineData("lod=off", "--lod-error 1", "")]
    [InlineData("samples=9,timeout=5", "", "--timeout")]
    [InlineData("samples=9,timeout=5", "--renderer native", "--samples")]
    [InlineData("renderer=native,samples=9,timeout=5", "", "--renderer,--samples")]
    [InlineData("fov=30", "--fov 40", "")]
    [InlineData("margin=1", "", "")]
    public void Applicable_SettingsThatACallCantUse_AreLeftOut(string inFile, string onLine, string kept)
    {
        IEnumerable<ConfigValue> file = inFile.Split(',').Select(pair => pair.Split('='))
            .Select(
                pair => new ConfigValue(ConfigKeys.Allowed.Single(option => option.Key == pair[0]), pair[1], "a.yaml", Line: 1, Rank: 1));

        IEnumerable<string> applied = ConfigRules.Applicable(
            file, Given.Options(onLine), CommandTable.Render).Select(value => value.Option.Name);
        Assert.Equal(kept, string.Join(',', applied.Order(StringComparer.Ordinal)));
    }
}
