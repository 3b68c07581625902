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
    public static StreamWriter TextWriterOn(Stream stream) =>
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

    /// <summary>Takes files whose names begin alike.</summary>
    /// <param name="stem">What they begin with, before a dot.</param>
    /// <param name="paths">Receives their paths, in the order in which they are begun.</param>
    public PutFile Under(string stem, List<string> paths) => (name, _, write) =>
    {
        string path = $"{stem}.{name}";
        paths.Add(path);
        Write(path, write);
    };

    /// <summary>Gives all files their final names, in the order in which they were written; existing files are replaced.</summary>
    /// <param name="lastFirst">Whether the order is the other way round.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void Commit(bool lastFirst = false)
    {
        while (_pending.Count > 0)
        {
            int next = lastFirst ? _pending.Count - 1 : 0;
            (string temporary, string path) = _pending[next];
            Wrapped(path, () => File.Move(temporary, path, overwrite: true));
            _pending.RemoveAt(next);
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

/// <summary>Takes a file: on disk, or as a part of an answer.</summary>
/// <param name="name">Its name without what the names of all its files begin with, e.g. "depth.npy".</param>
/// <param name="length">bytes; null if that is not known before it is written.</param>
/// <param name="write">Writes the content.</param>
public delegate void PutFile(string name, long? length, Action<Stream> write);

/// <summary>What is written on a <see cref="PutFile"/>.</summary>
public static class PutFiles
{
    /// <summary>Puts a text file, UTF-8 without byte order mark, LF.</summary>
    public static void Text(this PutFile put, string name, Action<TextWriter> write) => put(name, null, stream =>
    {
        using StreamWriter writer = AtomicFileSet.TextWriterOn(stream);
        write(writer);
    });
}
