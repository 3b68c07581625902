using Msisf.Adapters.IO;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.IO;

public sealed class AtomicFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void WriteText_NewFile_HoldsTheTextAlone()
    {
        AtomicFile.WriteText(_folder["a.txt"], writer => writer.WriteLine("Grüße"));

        Assert.Equal("Gr\u00fc\u00dfe\n"u8.ToArray(), File.ReadAllBytes(_folder["a.txt"]));
        Assert.Single(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Write_WriterFails_KeepsTheOldFileAndNoOther()
    {
        File.WriteAllText(_folder["a.txt"], "old");

        Assert.Throws<InvalidOperationException>(() => AtomicFile.Write(_folder["a.txt"], stream =>
        {
            stream.WriteByte(1);
            throw new InvalidOperationException();
        }));

        Assert.Equal("old", File.ReadAllText(_folder["a.txt"]));
        Assert.Single(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Write_FolderIsMissing_SaysSo()
    {
        string path = Path.Combine(_folder["missing"], "a.txt");

        ExternalPartException exception = Assert.Throws<ExternalPartException>(() => AtomicFile.Write(path, _ => { }));

        Assert.Contains(path, exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Write_WhileBeingWritten_ShowsNothingUnderTheFinalName() =>
        AtomicFile.Write(_folder["a.txt"], stream =>
        {
            stream.WriteByte(1);
            stream.Flush();
            Assert.False(File.Exists(_folder["a.txt"]));
        });
}
