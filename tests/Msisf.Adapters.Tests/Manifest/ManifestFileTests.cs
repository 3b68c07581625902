using System.Text;
using Msisf.Adapters.Manifest;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Manifest;

public sealed class ManifestFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Append_ManyThreadsThroughTwoObjects_KeepsEachLineWhole()
    {
        ManifestFile[] files = [new(_folder.Path), new(_folder.Path)];
        Parallel.For(0, 400, step => files[step % 2].Append(new RunRecord($"r{step}", new string('s', step), step + 1)));

        ManifestContent content = Read();
        Assert.Equal(0, content.DamagedLines);
        Assert.Equal(400, content.Runs.Count);
        Assert.Equal(400, File.ReadAllLines(files[0].FilePath).Length);
    }

    [Fact]
    public void Append_AfterALineThatWasCutOff_TakesTheCutOffPartAway()
    {
        ManifestFile file = new(_folder.Path);
        file.Append(new RunRecord("r1", "s", 1));
        File.AppendAllText(file.FilePath, """{"record":"run","run":"r2","sett""");
        file.Append(new RunRecord("r3", "s", 1));

        ManifestContent content = Read();
        Assert.Equal(["r1", "r3"], content.Runs.Keys.Order(StringComparer.Ordinal));
        Assert.Equal(0, content.DamagedLines);
    }

    [Fact]
    public void Append_FolderIsNotThere_SaysWhichFile()
    {
        ExternalPartException failure = Assert.Throws<ExternalPartException>(
            () => new ManifestFile(_folder["none"]).Append(new RunRecord("r1", "s", 1)));

        Assert.Contains("msisf-manifest.jsonl: can't be written", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Refresh_LinesAppendedMeanwhile_AreReadOnce()
    {
        ManifestFile file = new(_folder.Path);
        using ManifestReader reader = new(file);
        Assert.False(reader.Refresh());
        file.Append(new RunRecord("r1", "s", 1));
        Assert.True(reader.Refresh());
        Assert.False(reader.Refresh());

        // A line that another process is just writing.
        byte[] line = ManifestLine.Write(new RunRecord("r2", "s", 1));
        using FileStream stream = new(file.FilePath, FileMode.Append, FileAccess.Write, FileShare.ReadWrite);
        stream.Write(line, 0, 10);
        stream.Flush();
        Assert.True(reader.Refresh());
        Assert.Equal(["r1"], reader.Content.Runs.Keys);
        stream.Write(line, 10, line.Length - 10);
        stream.Flush();
        Assert.True(reader.Refresh());
        Assert.Equal("r2", reader.Content.LastRun);
        Assert.Equal(0, reader.Content.DamagedLines);
    }

    [Fact]
    public void Refresh_OnlyNew_LeavesOutWhatWasThere()
    {
        ManifestFile file = new(_folder.Path);
        file.Append(new RunRecord("r1", "s", 1));
        using ManifestReader reader = new(file, onlyNew: true);
        file.Append(new RunRecord("r2", "s", 1));
        reader.Refresh();

        Assert.Equal(["r2"], reader.Content.Runs.Keys);
    }

    [Fact]
    public void Refresh_LineOfManyMegabytes_IsOneDamagedLine()
    {
        ManifestFile file = new(_folder.Path);
        File.WriteAllText(
            file.FilePath, new string('x', 5_000_000) + "\n" + Encoding.UTF8.GetString(ManifestLine.Write(new RunRecord("r1", "s", 1))));
        ManifestContent content = Read();

        Assert.Equal(1, content.DamagedLines);
        Assert.Equal("r1", content.LastRun);
    }

    private ManifestContent Read()
    {
        using ManifestReader reader = new(new ManifestFile(_folder.Path));
        reader.Refresh();
        return reader.Content;
    }
}
