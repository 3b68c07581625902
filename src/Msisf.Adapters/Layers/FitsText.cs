using System.Text;

namespace Msisf.Adapters.Layers;

/// <summary>Texts for FITS headers, which hold printable ASCII only.</summary>
internal static class FitsText
{
    /// <summary>Characters of a COMMENT card.</summary>
    private const int CardText = 72;

    /// <summary>
    /// Escapes characters that are not printable ASCII as JSON does (\u00e4), each UTF-16 unit for itself, and the backslash, so that
    /// nothing is lost. The apostrophe is escaped too: FITS could hold it, but astropy before 5.3 ends a long text at one.
    /// </summary>
    public static string Ascii(string text)
    {
        StringBuilder ascii = new(text.Length);
        foreach (char character in text)
        {
            if (character is >= ' ' and <= '~' and not '\'' and not '\\')
            {
                ascii.Append(character);
            }
            else
            {
                ascii.Append(CultureInfo.InvariantCulture, $"\\u{(int)character:x4}");
            }
        }

        return ascii.ToString();
    }

    /// <summary>Breaks a text of short words into lines for COMMENT cards.</summary>
    public static IEnumerable<string> Wrap(string text)
    {
        StringBuilder line = new();
        foreach (string word in text.Split(' '))
        {
            if (line.Length > 0 && line.Length + 1 + word.Length > CardText)
            {
                yield return line.ToString();
                line.Clear();
            }

            line.Append(line.Length > 0 ? " " : string.Empty).Append(word);
        }

        yield return line.ToString();
    }
}
