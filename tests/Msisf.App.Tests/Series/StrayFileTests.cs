using Msisf.Adapters.Manifest;
using Msisf.App.Series;
using Msisf.App.Tests.Host;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Series;

/// <summary>What a folder of outputs has beside its manifest, and folders without one.</summary>
public sealed class StrayFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void In_FilesWithoutARecord_AreSortedAndThoseNamedAsAFrameAreLeftOver()
    {
        ManifestContent manifest = new();
        manifest.Add(new ExpectedRecord("run", 1, "a", "key"));
        manifest.Add(new FrameRecord(1, "a", "key", "settings", [new OutputFile("a.png", 1, "aa")]));
        foreach (string name in new[] { "a.png", "a.xml", "notes.txt", ".hidden", ManifestFile.Name, "b.png" })
        {
            _folder.Write(name, string.Empty);
        }

        IReadOnlyList<StrayFile> strays = StrayFile.In(_folder.Path, manifest);
        Assert.Equal([("a.xml", true), ("b.png", false), ("notes.txt", false)], strays.Select(file => (file.Name, file.IsLeftOver)));
        Assert.StartsWith("the record of its frame does not name it", strays[0].Reason, StringComparison.Ordinal);
        Assert.Equal("no record names it", strays[1].Reason);

        manifest.Add(new ExpectedRecord("run", 2, "b", "other"));
        StrayFile unrecorded = StrayFile.In(_folder.Path, manifest)[1];
        Assert.True(unrecorded.IsLeftOver);
        Assert.StartsWith("this folder has no record of its frame", unrecorded.Reason, StringComparison.Ordinal);
    }

    [Fact]
    public void Manifest_MissingFolderFileOrRun_IsRefusedByItsPath()
    {
        ListLog log = new();
        Assert.Equal(
            $"{_folder["none"]}: there is no such folder. Name the --output-dir of a run.",
            Assert.Throws<BadInputException>(() => SeriesManifest.Read(_folder["none"], log)).Message);
        string path = _folder[ManifestFile.Name];
        Assert.Equal(
            $"{path}: missing. Name the --output-dir of a run.",
            Assert.Throws<BadInputException>(() => SeriesManifest.Read(_folder.Path, log)).Message);

        _folder.Write(ManifestFile.Name, "{ no line of a manifest\n");

        Assert.Equal(
            $"{path}: no run is in it. Name the --output-dir of a run.",
            Assert.Throws<BadInputException>(() => SeriesManifest.Read(_folder.Path, log)).Message);
        Assert.Equal([$"warning: {path}: 1 lines can't be read and are left out."], log.Lines);
    }
}
