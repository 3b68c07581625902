using System.Text;

namespace Msisf.Adapters.Input;

/// <summary>Text files of other programs, in whichever encoding they are.</summary>
public static class TextFile
{
    private static readonly (byte[] Mark, Encoding Encoding)[] Marks =
    [
        ([0xEF, 0xBB, 0xBF], Encoding.UTF8), ([0xFF, 0xFE], Encoding.Unicode), ([0xFE, 0xFF], Encoding.BigEndianUnicode),
    ];

    /// <summary>Decodes a text: by its byte order mark (UTF-8, UTF-16), as UTF-8 if it is that, and otherwise as ISO 8859-1.</summary>
    /// <returns>The text without mark, and whether it is ISO 8859-1 because it is not UTF-8.</returns>
    public static (string Text, bool IsLatin1) Decode(ReadOnlySpan<byte> content)
    {
        foreach ((byte[] mark, Encoding encoding) in Marks)
        {
            if (content.StartsWith(mark))
            {
                return (encoding.GetString(content[mark.Length..]), false);
            }
        }

        try
        {
            return (new UTF8Encoding(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true).GetString(content), false);
        }
        catch (DecoderFallbackException)
        {
            return (Encoding.Latin1.GetString(content), true);
        }
    }
}
