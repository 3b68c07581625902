using System.Globalization;
using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Adapters.IO;

/// <summary>Writes a file whole or not at all: under a name of its own in the same folder, flushed to disk, then renamed.</summary>
public static class AtomicFile
{
    /// <summary>What the names of unfinished files end in, before their extension.</summary>
    public const string PartialMark = ".partial";

    /// <summary>Writes one file; an existing file is replaced at the end, in one step.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="write">Writes the content; the stream can seek.</param>
    /// <param name="flushToDisk">False only for files that can be made again and carry their own check: after a power cut such a file may be empty or short.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void Write(string path, Action<Stream> write, bool flushToDisk = true)
    {
        string temporary = TemporaryNameFor(path);
        try
        {
            try
            {
                using (FileStream stream = new(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 65536))
                {
                    write(stream);
                    stream.Flush(flushToDisk);
                }

                File.Move(temporary, path, overwrite: true);
            }
            catch
            {
                RemoveIfThere(temporary);
                throw;
            }
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"{path}: can't be written: {exception.Message}", exception);
        }
    }

    /// <summary>Writes a text file, UTF-8 without byte order mark, LF.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="write">Writes the content.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void WriteText(string path, Action<TextWriter> write) => Write(path, stream =>
    {
        using StreamWriter writer = new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), bufferSize: 65536, leaveOpen: true);
        writer.NewLine = "\n";
        write(writer);
    });

    /// <summary>A name beside <paramref name="path"/> that no other process or thread uses, with the same extension.</summary>
    public static string TemporaryNameFor(string path)
    {
        string folder = Path.GetDirectoryName(path) ?? string.Empty;
        string unique = string.Create(CultureInfo.InvariantCulture, $".{Environment.ProcessId}-{Guid.NewGuid():N}{PartialMark}");
        return Path.Combine(folder, Path.GetFileNameWithoutExtension(path) + unique + Path.GetExtension(path));
    }

    /// <summary>File.Delete is content with a missing file, but not with a missing folder.</summary>
    private static void RemoveIfThere(string temporary)
    {
        if (File.Exists(temporary))
        {
            File.Delete(temporary);
        }
    }
}
