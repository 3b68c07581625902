using System.Globalization;
using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Adapters.IO;

/// <summary>Writes a file whole or not at all: under a name of its own in the same folder, flushed to disk, then renamed.</summary>
public static class AtomicFile
{
    /// <summary>Writes one file; an existing file is replaced at the end, in one step.</summary>
    /// <param name="path">The final name.</param>
    /// <param name="write">Writes the content.</param>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void Write(string path, Action<Stream> write)
    {
        string temporary = TemporaryNameFor(path);
        try
        {
            using (FileStream stream = new(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 65536))
            {
                write(stream);
                stream.Flush(flushToDisk: true);
            }

            File.Move(temporary, path, overwrite: true);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"{path}: can't be written: {exception.Message}", exception);
        }
        finally
        {
            File.Delete(temporary);
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
        string unique = string.Create(CultureInfo.InvariantCulture, $".{Environment.ProcessId}-{Guid.NewGuid():N}.partial");
        return Path.Combine(folder, Path.GetFileNameWithoutExtension(path) + unique + Path.GetExtension(path));
    }
}
