using System.Text;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Opens kernel files.</summary>
internal static class KernelFile
{
    private const int IdWordBytes = 8;

    /// <summary>
    /// The first eight characters up to the first blank, by which SPICE tells the kinds of kernels; "" for an empty file.
    /// </summary>
    public static string IdWordOf(string path)
    {
        using FileStream stream = OpenBinary(path);
        Span<byte> start = stackalloc byte[IdWordBytes];
        int read = stream.ReadAtLeast(start, IdWordBytes, throwOnEndOfStream: false);
        string text = Encoding.Latin1.GetString(start[..read]);
        int end = text.AsSpan().IndexOfAny(" \r\n\t");
        return end < 0 ? text : text[..end];
    }

    /// <summary>Whether a kernel is binary, by its first characters.</summary>
    /// <exception cref="BadInputException">It is of no kind that is known.</exception>
    public static bool IsBinary(string path)
    {
        string idWord = IdWordOf(path);
        bool isBinary = idWord is "DAF/SPK" or "DAF/PCK" or "DAF/CK" or "DAS/DSK" or "DAS/EK";
        return isBinary || !(idWord.Contains('\0', StringComparison.Ordinal) || idWord is "NAIF/DAF" or "DAFETF")
            ? isBinary
            : throw new BadInputException(
                $"{path}: neither a text kernel nor a binary SPK or PCK: the file begins with \"{idWord.Replace('\0', '?')}\". "
                    + $"Get the file anew, or convert it with NAIF's tobin.");
    }

    public static StreamReader OpenText(string path) => new(OpenBinary(path), Encoding.UTF8);

    /// <summary>Opens a binary kernel. The stream has no buffer, because each read takes a whole record.</summary>
    public static FileStream OpenBinary(string path) => FileErrors.ToBadInput(
        $"{path}: the kernel can't be opened",
        () => new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 0));
}
