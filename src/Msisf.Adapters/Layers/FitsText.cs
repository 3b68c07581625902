using System.Globalization;
using System.Text;

namespace Msisf.Adapters.Layers;

/// <summary>Texts for FITS headers, which hold printable ASCII only.</summary>
internal static class FitsText
{
    /// <summary>Characters of a COMMENT card.</summary>
    private const int CardText = 72;

    /// <summary>Writes what is not printable ASCII as C# does: \u00e4. Each UTF-16 unit for itself, so that nothing is lost.</summary>
    public static string Ascii(string text)
    {
        StringBuilder ascii = new(text.Length);
        foreach (char character in text)
        {
            if (character is >= ' ' and <= '~')
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
