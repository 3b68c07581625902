using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class LdemCatalogTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Find_SeveralLabels_PrefersTheDefaultName()
    {
        Put("A_SYNTHETIC.LBL");
        Put("LDEM_1.LBL");

        Assert.Equal(_folder["LDEM_1.LBL"], Find(1).Location);
    }

    [Fact]
    public void Find_AnotherName_IsTakenByItsResolution()
    {
        Put("notes.lbl", "not a label");
        Put("SYNTHETIC_B.LBL");
        Put("SYNTHETIC_A.LBL");

        Assert.Equal(_folder["SYNTHETIC_A.LBL"], Find(1).Location);
    }

    [Fact]
    public void Find_SeveralFolders_TakesTheFirstThatHasOne()
    {
        Put("ldem_1.lbl");

        Assert.Equal(_folder["ldem_1.lbl"], LdemCatalog.Find(1, null, ["/nowhere", _folder.Path]).Location);
    }

    [Theory]
    [InlineData("LDEM_1.LBL")]
    [InlineData("ldem_1.img")]
    [InlineData("")]
    public void Find_ExplicitPath_MayBeLabelImageOrFolder(string name)
    {
        Put("LDEM_1.LBL");
        File.WriteAllBytes(_folder["ldem_1.img"], []);

        Assert.Equal(_folder["LDEM_1.LBL"], LdemCatalog.Find(1, _folder[name], []).Location);
    }

    /// <summary>One resolution is that of the folder; of several the usual one counts, and without it the user has to choose.</summary>
    [Fact]
    public void ResolutionIn_AFolder_IsThatOfItsModels()
    {
        Assert.Equal(4, LdemCatalog.ResolutionIn(_folder.Path, 4, CelestialBody.Moon));

        Put("LDEM_1.LBL");
        Put("notes.lbl", "not a label");
        Assert.Equal(1, LdemCatalog.ResolutionIn(_folder.Path, 4, CelestialBody.Moon));
        Assert.Equal(4, LdemCatalog.ResolutionIn(_folder.Path, 4, CelestialBody.Find("MERCURY")!));
        Assert.Equal(1, LdemCatalog.ResolutionIn(_folder.Path, 1, CelestialBody.Moon));
    }

    [Fact]
    public void TryFind_Nothing_IsNull()
    {
        Put("LDEM_1.LBL");

        Assert.Null(LdemCatalog.TryFind(16, null, ["/nowhere", _folder.Path]));
        Assert.Equal(_folder["LDEM_1.LBL"], LdemCatalog.TryFind(1, null, ["/nowhere", _folder.Path])?.Location);
    }

    [Fact]
    public void Find_Nothing_SaysWhereItLookedAndWhatToDo()
    {
        Put("LDEM_1.LBL");

        string message = Assert.Throws<BadInputException>(() => LdemCatalog.Find(16, null, ["/nowhere", _folder.Path])).Message;

        Assert.Equal(
            $"No elevation model of 16 px/deg in /nowhere, {_folder.Path}. Get NASA's with 'msis fetch ldem --res 16', "
                + "name another one with --ldem, or make a synthetic one with 'msis ldem synthesize --res 16 --base LDEM_4.LBL --seed 1'.",
            message);
    }

    [Fact]
    public void Find_ResolutionThatNasaDoesNotHave_SaysWhichThereAre() => Assert.Contains(
        "NASA has models of 4, 16, 64, 128, 256, 512, 1024 px/deg, name another one with --ldem",
        Assert.Throws<BadInputException>(() => LdemCatalog.Find(32, null, [_folder.Path])).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Find_ExplicitModelOfAnotherResolution_SaysSo()
    {
        Put("LDEM_1.LBL");

        string message = Assert.Throws<BadInputException>(() => LdemCatalog.Find(4, _folder["LDEM_1.LBL"], [])).Message;

        Assert.Contains("of 1 px/deg, but 4 px/deg are asked for", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Find_NameThatLiesAboutTheResolution_SaysSo()
    {
        Put("LDEM_16.LBL");

        Assert.Contains("MAP_RESOLUTION is 1", Assert.Throws<BadInputException>(() => Find(16)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Find_ExplicitPathThatIsMissing_NamesIt() =>
        Assert.Contains(
            "gone.lbl: there is no such file",
            Assert.Throws<BadInputException>(() => LdemCatalog.Find(1, _folder["gone.lbl"], [])).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData("LDEM_1_45S_00S_090_180.LBL")]
    [InlineData("LDEM_1_45N_90N_000_090.IMG")]
    [InlineData("")]
    public void Find_ExplicitPathToASplitProduct_TakesTheOtherParts(string name)
    {
        SplitModel.Write(_folder.Path, 45, 90);

        LdemSet set = LdemCatalog.Find(1, _folder[name], []);

        Assert.Equal(("LDEM_1", 16), (set.ProductId, set.Parts.Count));
        Assert.Equal($"{_folder.Path.TrimEnd('/')}, 16 files", set.Description.Replace("/,", ",", StringComparison.Ordinal));
    }

    [Fact]
    public void Find_WholeAndSplitProduct_TakesTheWhole()
    {
        SplitModel.Write(_folder.Path, 90, 180);
        Put("WHOLE.LBL");

        Assert.Equal(_folder["WHOLE.LBL"], Find(1).Location);
    }

    [Fact]
    public void Find_TwoSplitProducts_KeepsThemApart()
    {
        foreach (string name in SplitModel.Write(_folder.Path, 90, 180))
        {
            string text = File.ReadAllText(_folder[name + ".LBL"]);
            Put($"{name}_FLOAT.LBL", text.Replace($"\"{name}\"", $"\"{name}_FLOAT\"", StringComparison.Ordinal));
        }

        File.Delete(_folder["LDEM_1_90S_00S_000_180.LBL"]);

        Assert.Equal(("LDEM_1_FLOAT", 4), (Find(1).ProductId, Find(1).Parts.Count));
    }

    [Fact]
    public void Find_IncompleteSetInTheFirstFolder_TakesTheNext()
    {
        SplitModel.WritePart(_folder.Path, 90, 0, 0, 180);
        using TemporaryFolder second = new();
        SplitModel.Write(second.Path, 90, 180);

        Assert.Equal(4, LdemCatalog.Find(1, null, [_folder.Path, second.Path]).Parts.Count);
    }

    /// <summary>A model of another body is found for that body, and taken for no other.</summary>
    [Fact]
    public void Find_OtherBody_IsOfThatBodyOnly()
    {
        string label = TestModel.Label
            .Replace("LDEM_1", "MERCURY_1", StringComparison.Ordinal)
            .Replace("TARGET_NAME               = MOON", "TARGET_NAME = MERCURY", StringComparison.Ordinal)
            .Replace("1737400.", "2439400.", StringComparison.Ordinal)
            .Replace("1737.4 <km>", "2439.4 <km>", StringComparison.Ordinal)
            .Replace("MEAN EARTH/POLAR AXIS OF DE421", "PLANETOCENTRIC", StringComparison.Ordinal);
        File.WriteAllText(_folder["MERCURY_1.LBL"], label);
        CelestialBody mercury = CelestialBody.Of(199);

        LdemSet found = LdemCatalog.Find(1, _folder["MERCURY_1.LBL"], [], body: mercury);

        Assert.Equal((mercury, 2_439_400.0), (found.Body, found.ReferenceRadius));
        Assert.Contains(
            "MERCURY_1.LBL: a model of Mercury, but one of the Moon is needed here. --body says",
            Assert.Throws<BadInputException>(() => LdemCatalog.Find(1, _folder["MERCURY_1.LBL"], [])).Message,
            StringComparison.Ordinal);
        File.Delete(_folder["LDEM_1.LBL"]);
        Assert.Null(LdemCatalog.TryFind(1, null, [_folder.Path]));
    }

    private LdemSet Find(int resolution) => LdemCatalog.Find(resolution, null, [_folder.Path]);

    private void Put(string name, string text = TestModel.Label) => File.WriteAllText(_folder[name], text);
}
