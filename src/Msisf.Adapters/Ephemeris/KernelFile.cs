using System.Text;
using Msisf.Core.Errors;

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

    /// <summary>Opens a text kernel.</summary>
    public static StreamReader OpenText(string path) => new(OpenBinary(path), Encoding.UTF8);

    /// <summary>Opens a binary kernel. The stream has no buffer, because each read takes a whole record.</summary>
    public static FileStream OpenBinary(string path) => FileErrors.ToBadInput(
        $"{path}: the kernel can't be opened",
        () => new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 0));
}
