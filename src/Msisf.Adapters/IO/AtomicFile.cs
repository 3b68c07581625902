namespace Msisf.Adapters.IO;

/// <summary>Writes a file completely or not at all: under a temporary name in the same folder, flushed to disk, then renamed.</summary>
public static class AtomicFile
{
    /// <summary>The end of an unfinished file's name, before its extension.</summary>
    public const string PartialMark = ".partial";

    /// <summary>Writes one file. An existing file is replaced in one step, at the end.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="write">Writes the content; the stream can seek.</param>
    /// <param name="flushToDisk">
    /// False only for files that can be made again and carry their own check: after a power cut such a file may be empty or short.
    /// </param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void Write(string path, Action<Stream> write, bool flushToDisk = true)
    {
        using AtomicFileSet files = new();
        files.Write(path, write, flushToDisk);
        files.Commit();
    }

    /// <summary>
    /// Writes one file that no other process or thread may write meanwhile. Its unfinished file always has the same name, so that the next
    /// to write it replaces what a killed process left.
    /// </summary>
    /// <param name="path">The final name; the caller has an exclusive <see cref="Claim"/> on it.</param>
    /// <param name="write">Writes the content; the stream can seek.</param>
    /// <param name="flushToDisk">See <see cref="Write"/>.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void WriteClaimed(string path, Action<Stream> write, bool flushToDisk = true)
    {
        using AtomicFileSet files = new();
        files.WriteClaimed(path, write, flushToDisk);
        files.Commit();
    }

    /// <summary>Writes a text file, UTF-8 without byte order mark, LF.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="write">Writes the content.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void WriteText(string path, Action<TextWriter> write)
    {
        using AtomicFileSet files = new();
        files.WriteText(path, write);
        files.Commit();
    }

    /// <summary>A name beside <paramref name="path"/> that no other process or thread uses, with the same extension.</summary>
    public static string TemporaryNameFor(string path) =>
        PartialNameFor(path, Invariant($".{Environment.ProcessId}-{Guid.NewGuid():N}"));

    /// <summary>The name of an unfinished file beside <paramref name="path"/>, with the same extension.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="unique">What tells several apart that are written at once.</param>
    internal static string PartialNameFor(string path, string unique = "") => Path.Combine(
        Path.GetDirectoryName(path) ?? string.Empty,
        Path.GetFileNameWithoutExtension(path) + unique + PartialMark + Path.GetExtension(path));
}
