using Msisf.Adapters.Raster;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Surface.Sources;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>The files of the seams between several models.</summary>
public sealed class SeamFilesTests : IDisposable
{
    private static readonly string[] Borders = [new('a', 64), "0123456789abcdef" + new string('b', 48)];

    private readonly TemporaryFolder _folder = new();
    private readonly List<string> _warnings = [];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Find_AfterKeep_IsWhatWasKept()
    {
        SeamFiles files = Files(Model());
        files.Keep(Filling());

        GapTriangulation found = files.Find("LDEM_1", Borders[1])!;
        Assert.Equal(Borders, found.Borders);
        Assert.Equal(Filling().Corners, found.Corners);
        Assert.Equal(["LDEM_1.0123456789abcdef.seam"], Seams().Select(Path.GetFileName));
        Assert.Null(files.Find("LDEM_1", Borders[0]));
        Assert.Null(files.Find("LDEM_2", Borders[1])); // no model of the scene
        Assert.Empty(_warnings);
    }

    /// <summary>Each byte that is another, and each end that is missing.</summary>
    [Fact]
    public void Find_DamagedFile_IsMissing_AndKeepMendsIt()
    {
        SeamFiles files = Files(Model());
        files.Keep(Filling());
        string path = Seams().Single();
        byte[] whole = File.ReadAllBytes(path);
        for (int place = 0; place < whole.Length; place++)
        {
            byte[] damaged = [.. whole];
            damaged[place] ^= 4;
            File.WriteAllBytes(path, damaged);
            Assert.Null(files.Find("LDEM_1", Borders[1]));
            File.WriteAllBytes(path, whole[..place]);
            Assert.Null(files.Find("LDEM_1", Borders[1]));
        }

        files.Keep(Filling());
        Assert.Equal(whole, File.ReadAllBytes(path));
        Assert.NotNull(files.Find("LDEM_1", Borders[1]));
    }

    /// <summary>The name has a part of the hash only.</summary>
    [Fact]
    public void Find_FileOfAnotherBorder_IsMissing()
    {
        SeamFiles files = Files(Model());
        files.Keep(Filling());
        Assert.Null(files.Find("LDEM_1", Borders[1][..16] + new string('c', 48)));
    }

    [Fact]
    public void Keep_NoFolderTakesFiles_Warns()
    {
        string model = Model();
        SeamFiles files = new([LdemCatalog.Read(model)], cacheFolder: null, _warnings.Add);
        string path = Path.ChangeExtension(model, ".0123456789abcdef.seam");
        Directory.CreateDirectory(path); // stands in the way, also of root
        files.Keep(Filling());

        Assert.Contains("The seams of LDEM_1 are made again in the next run.", Assert.Single(_warnings), StringComparison.Ordinal);
        Assert.Null(files.Find("LDEM_1", Borders[1]));
    }

    [Fact]
    public void Find_FileInTheCache_IsFound()
    {
        string model = Model();
        string cache = _folder["cache"];
        new SeamFiles([LdemCatalog.Read(model)], cache, _warnings.Add).Keep(Filling());
        SidecarPlaces places = LdemCatalog.Read(model).PlacesOf(".0123456789abcdef.seam", cache);
        Directory.CreateDirectory(cache);
        File.Move(places.Beside, places.Cached!);

        Assert.NotNull(new SeamFiles([LdemCatalog.Read(model)], cache, _warnings.Add).Find("LDEM_1", Borders[1]));
        Assert.Null(Files(model).Find("LDEM_1", Borders[1]));
    }

    private static GapTriangulation Filling() => new("LDEM_1", Borders, [0, 1, 2, 70000, 3, 1]);

    private SeamFiles Files(string model) => new([LdemCatalog.Read(model)], cacheFolder: null, _warnings.Add);

    private string[] Seams() => Directory.GetFiles(_folder.Path, "*.seam", SearchOption.AllDirectories);

    private string Model() => TestModel.Write(_folder.Path, TestModel.Label, TestModel.IntegerImage(bigEndian: false));
}
