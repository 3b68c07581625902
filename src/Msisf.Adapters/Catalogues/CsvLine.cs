using System.Text;

namespace Msisf.Adapters.Catalogues;

/// <summary>Lines of CSV.</summary>
public static class CsvLine
{
    /// <summary>Whether a line ends within quotes, so that its last field goes on in the next one.</summary>
    public static bool IsOpen(string line) => line.AsSpan().Count('"') % 2 == 1;

    /// <summary>The fields of a line; those in double quotes may hold the separator, and a quote as two of them.</summary>
    public static List<string> Fields(string line, char separator)
    {
        List<string> fields = [];
        StringBuilder field = new();
        bool isQuoted = false;
        foreach (char letter in line)
        {
            if (letter == '"')
            {
                isQuoted = !isQuoted;
                if (isQuoted && field.Length > 0)
                {
                    field.Append('"');
                }
            }
            else if (letter == separator && !isQuoted)
            {
                fields.Add(field.ToString());
                field.Clear();
            }
            else
            {
                field.Append(letter);
            }
        }

        fields.Add(field.ToString());
        return fields;
    }

    /// <summary>A text as a field: in quotes where it needs them.</summary>
    public static string Field(string text) => text.AsSpan().IndexOfAny(",\"\r\n") < 0
        ? text
        : $"\"{text.Replace("\"", "\"\"", StringComparison.Ordinal)}\"";
}
