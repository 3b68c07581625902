using Msisf.Adapters.Terrain;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Terrain;

public sealed class LdemCatalogTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Find_SeveralLabels_PrefersTheUsualName()
    {
        Put("A_SYNTHETIC.LBL");
        Put("LDEM_1.LBL");

        Assert.Equal(_folder["LDEM_1.LBL"], Find(1).LabelPath);
    }

    [Fact]
    public void Find_AnotherName_IsTakenByItsResolution()
    {
        Put("notes.lbl", "not a label");
        Put("SYNTHETIC_B.LBL");
        Put("SYNTHETIC_A.LBL");

        Assert.Equal(_folder["SYNTHETIC_A.LBL"], Find(1).LabelPath);
    }

    [Fact]
    public void Find_SeveralFolders_TakesTheFirstThatHasOne()
    {
        Put("ldem_1.lbl");

        Assert.Equal(_folder["ldem_1.lbl"], LdemCatalog.Find(1, null, ["/nowhere", _folder.Path]).LabelPath);
    }

    [Theory]
    [InlineData("LDEM_1.LBL")]
    [InlineData("ldem_1.img")]
    [InlineData("")]
    public void Find_ExplicitPath_MayBeLabelImageOrFolder(string name)
    {
        Put("LDEM_1.LBL");
        File.WriteAllBytes(_folder["ldem_1.img"], []);

        Assert.Equal(_folder["LDEM_1.LBL"], LdemCatalog.Find(1, _folder[name], []).LabelPath);
    }

    [Fact]
    public void Find_Nothing_SaysWhereItLookedAndWhatToDo()
    {
        Put("LDEM_1.LBL");

        string message = Assert.Throws<BadInputException>(() => LdemCatalog.Find(16, null, ["/nowhere", _folder.Path])).Message;

        Assert.Contains($"No elevation model of 16 px/deg in /nowhere, {_folder.Path}: put LDEM_16.LBL and .IMG there", message, StringComparison.Ordinal);
    }

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
        Assert.Contains("gone.lbl: can't be read", Assert.Throws<BadInputException>(() => LdemCatalog.Find(1, _folder["gone.lbl"], [])).Message, StringComparison.Ordinal);

    private LdemLabel Find(int resolution) => LdemCatalog.Find(resolution, null, [_folder.Path]);

    private void Put(string name, string text = TestModel.Label) => File.WriteAllText(_folder[name], text);
}
