using System.Text;

namespace Msisf.Adapters.Metadata;

/// <summary>Text as XML 1.0 character data.</summary>
internal static class XmlText
{
    private const char ControlImages = '\u2400';

    /// <summary>
    /// Escapes a text for element content. Tab and line ends become references, so that a parser gives them back as they were;
    /// the control characters that XML can't hold become their images (U+2400 and on), unpaired surrogates and
    /// non-characters the replacement character.
    /// </summary>
    public static string Escape(string text)
    {
        StringBuilder escaped = new(text.Length);
        foreach (Rune rune in text.EnumerateRunes())
        {
            escaped.Append(rune.Value switch
            {
                '&' => "&amp;",
                '<' => "&lt;",
                '>' => "&gt;",
                '\t' => "&#9;",
                '\n' => "&#10;",
                '\r' => "&#13;",
                < ' ' => $"{(char)(ControlImages + rune.Value)}",
                0xFFFE or 0xFFFF => Rune.ReplacementChar.ToString(),
                _ => rune.ToString(),
            });
        }

        return escaped.ToString();
    }

    /// <summary>Escapes a text for an attribute's value in double quotes.</summary>
    public static string EscapeAttribute(string text) => Escape(text).Replace("\"", "&quot;", StringComparison.Ordinal);
}
