using Msisf.Adapters.Input;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>wwwroot/js/names.js: the search among the names that come with the program.</summary>
[Collection(Chromium.Collection)]
public class NameTests(ModulePage page) : IClassFixture<ModulePage>
{
    [RequiresTheory(Part.Chromium)]
    [InlineData("apollo11", "Apollo 11")]
    [InlineData("Apollo 11", "Apollo 11")]
    [InlineData("APOLLO-11", "Apollo 11")]
    [InlineData("tycho", "Tycho")]
    [InlineData("TychoA", "Tycho A")]
    [InlineData("change 4", "Chang'e 4")]
    [InlineData("chang\u2019e4", "Chang'e 4")]
    [InlineData("becvar", "Be\u010Dv\u00E1\u0159")]
    [InlineData("engelhardt b", "Engel'gardt (Engelhardt) B")]
    [InlineData("imbrium", "Mare Imbrium")]
    public async Task Find_AnySpelling_HasThePlaceFirst(string text, string expected) =>
        Assert.Equal(expected, (await FindAsync(text))[0]);

    /// <summary>Those that begin with the text, then those with a word that does, then those that hold it.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task Find_SeveralNames_AreInTheOrderOfTheirWords()
    {
        object[] names = [new { name = "Aab", diameter = 9 }, new { name = "C ab", diameter = 8 }, new { name = "Abc", diameter = 7 }];
        Assert.Equal(["Abc", "C ab", "Aab"], await FindAsync("ab", names));
    }

    [RequiresTheory(Part.Chromium)]
    [InlineData("")]
    [InlineData("  ")]
    [InlineData("-'.")]
    [InlineData("zzzzzzzz")]
    public async Task Find_NothingToFind_IsEmpty(string text) => Assert.Empty(await FindAsync(text));

    private Task<string[]> FindAsync(string text) =>
        FindAsync(text, [.. PlaceNames.All.Select(place => new { name = place.Name, diameter = place.Diameter })]);

    private async Task<string[]> FindAsync(string text, object[] names) =>
        [.. (await page.CallAsync("names", "find", names, text)).EnumerateArray().Select(found => found.GetProperty("name").GetString()!)];
}
