namespace Msisf.Adapters.Tiles;

/// <summary>Tells by its first line and its length whether a file is the wanted pattern.</summary>
internal static class PatternFile
{
    /// <summary>What a file can be.</summary>
    public enum State
    {
        /// <summary>The wanted pattern, complete.</summary>
        Good,

        /// <summary>No file.</summary>
        Missing,

        /// <summary>A pattern of this program that is damaged, of another format, or made from other samples: it is made again.</summary>
        Outdated,

        /// <summary>A file that this program has not written: it is left alone.</summary>
        Foreign,
    }

    /// <summary>Checks a file by one read, whatever its size.</summary>
    /// <param name="headerWithoutLength">The header that is wanted (see <see cref="PatternHeader"/>).</param>
    /// <exception cref="ExternalPartException">The file is there but can't be read.</exception>
    public static State Inspect(string path, byte[] headerWithoutLength)
    {
        if (!File.Exists(path) && !Directory.Exists(path))
        {
            return State.Missing; // an exception would take as long as making a small pattern
        }

        try
        {
            using Microsoft.Win32.SafeHandles.SafeFileHandle file = File.OpenHandle(path, share: FileShare.ReadWrite | FileShare.Delete);
            Span<byte> start = stackalloc byte[headerWithoutLength.Length + PatternHeader.LengthDigits + 1];
            start = start[..RandomAccess.Read(file, start, fileOffset: 0)];
            return IsWanted(start, headerWithoutLength, RandomAccess.GetLength(file)) ? State.Good
                : IsOurs(start) ? State.Outdated
                : State.Foreign;
        }
        catch (Exception exception) when (exception is FileNotFoundException or DirectoryNotFoundException)
        {
            return State.Missing;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException(
                $"{path}: can't be read: {exception.Message} Move it away, or choose another pattern repository.", exception);
        }
    }

    private static bool IsWanted(ReadOnlySpan<byte> start, byte[] headerWithoutLength, long length) =>
        start.Length == headerWithoutLength.Length + PatternHeader.LengthDigits + 1
        && start.StartsWith(headerWithoutLength)
        && start[^1] == '\n'
        && long.TryParse(start[headerWithoutLength.Length..^1], NumberStyles.None, CultureInfo.InvariantCulture, out long expected)
        && expected == length;

    /// <summary>
    /// Whether it begins with our mark, or with as much of it as there are bytes. After a power cut a file can also be empty or all zeros.
    /// </summary>
    private static bool IsOurs(ReadOnlySpan<byte> start)
    {
        ReadOnlySpan<byte> mark = System.Text.Encoding.ASCII.GetBytes(PatternHeader.Mark);
        int common = Math.Min(mark.Length, start.Length);
        return start[..common].SequenceEqual(mark[..common]) || !start.ContainsAnyExcept((byte)0);
    }
}
