using System.Text;

namespace Msisf.Adapters.IO;

/// <summary>
/// Files that belong together: each is written under a temporary name and flushed to disk; at the end all get their final names. Not for
/// several threads.
/// </summary>
public sealed class AtomicFileSet : IDisposable
{
    private readonly List<(string Temporary, string Path)> _pending = [];
    private readonly string? _folder;

    /// <summary>Begins a set.</summary>
    /// <param name="folder">
    /// Where files are until they get their names, on the disk of the final ones: that of a <see cref="WorkFolder"/>, which does not
    /// outlast a killed process. Null for the folder of each file.
    /// </param>
    public AtomicFileSet(string? folder = null) => _folder = folder;

    /// <summary>Writes one file; its final name appears with <see cref="Commit"/>.</summary>
    /// <param name="write">Writes the content; the stream can seek.</param>
    /// <param name="flushToDisk">See <see cref="AtomicFile.Write"/>.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void Write(string path, Action<Stream> write, bool flushToDisk = true) => Write(
        path, AtomicFile.TemporaryNameFor(_folder is null ? path : Path.Combine(_folder, Path.GetFileName(path))), FileMode.CreateNew,
        write, flushToDisk);

    /// <summary>The same for a file that nobody else may write meanwhile (<see cref="AtomicFile.WriteClaimed"/>).</summary>
    internal void WriteClaimed(string path, Action<Stream> write, bool flushToDisk) =>
        Write(path, AtomicFile.PartialNameFor(path), FileMode.Create, write, flushToDisk);

    /// <summary>Writes one text file, UTF-8 without byte order mark, LF.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="write">Writes the content.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void WriteText(string path, Action<TextWriter> write) => Write(path, stream =>
    {
        using StreamWriter writer = TextWriterOn(stream);
        write(writer);
    });

    /// <summary>Writes text on a stream, which stays open: UTF-8 without byte order mark, LF.</summary>
    internal static StreamWriter TextWriterOn(Stream stream) =>
        new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), bufferSize: 65536, leaveOpen: true) { NewLine = "\n" };

    /// <summary>Length and checksum of a file that is written but not committed.</summary>
    /// <param name="path">Its final name.</param>
    /// <exception cref="ExternalPartException">It can't be read.</exception>
    public (long Bytes, string Sha256) Measure(string path)
    {
        string temporary = _pending.Single(file => file.Path == path).Temporary;
        (long, string) measured = default;
        Wrapped(path, () => measured = (new FileInfo(temporary).Length, FileHash.Sha256Of(temporary)));
        return measured;
    }

    /// <summary>Reads a file that is written but not committed.</summary>
    /// <param name="path">Its final name.</param>
    /// <param name="read">Reads the content.</param>
    /// <exception cref="ExternalPartException">It can't be read.</exception>
    public T Read<T>(string path, Func<Stream, T> read)
    {
        string temporary = _pending.Single(file => file.Path == path).Temporary;
        return FileErrors.ToExternalPart($"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(temporary);
            return read(stream);
        });
    }

    /// <summary>Gives all files their final names, in the order in which they were written; existing files are replaced.</summary>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void Commit()
    {
        while (_pending.Count > 0)
        {
            (string temporary, string path) = _pending[0];
            Wrapped(path, () => File.Move(temporary, path, overwrite: true));
            _pending.RemoveAt(0);
        }
    }

    /// <summary>Removes what was not committed.</summary>
    public void Dispose()
    {
        // File.Delete is content with a missing file, but not with a missing folder.
        foreach ((string temporary, string path) in _pending.Where(file => File.Exists(file.Temporary)))
        {
            Wrapped(path, () => File.Delete(temporary));
        }
    }

    private void Write(string path, string temporary, FileMode mode, Action<Stream> write, bool flushToDisk)
    {
        _pending.Add((temporary, path));
        Wrapped(path, () =>
        {
            using FileStream stream = new(temporary, mode, FileAccess.Write, FileShare.None, bufferSize: 65536);
            write(stream);
            stream.Flush(flushToDisk);
        });
    }

    private static void Wrapped(string path, Action work) => FileErrors.ToExternalPart($"{path}: can't be written", work);
}
