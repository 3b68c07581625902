namespace Msisf.Cli.Help;

/// <summary>Breaks text into lines for a terminal of 80 columns.</summary>
internal static class TextLayout
{
    /// <summary>Maximum length of a line, columns: the last of 80 columns is unused because some terminals break there.</summary>
    public const int Width = 79;

    /// <summary>Breaks a text into indented lines; a word longer than a line gets its own line.</summary>
    /// <param name="text">The text: words separated by blanks.</param>
    /// <param name="indent">Indentation of each line, columns.</param>
    public static IEnumerable<string> Lines(string text, int indent)
    {
        string line = string.Empty;
        foreach (string word in text.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        {
            if (line.Length > 0 && indent + line.Length + 1 + word.Length > Width)
            {
                yield return new string(' ', indent) + line;
                line = string.Empty;
            }

            line = line.Length == 0 ? word : $"{line} {word}";
        }

        yield return new string(' ', indent) + line;
    }

    /// <summary>Breaks a call of the program into lines, each continued by a backslash before an option.</summary>
    /// <param name="indent">Indentation of the first line, columns.</param>
    public static IEnumerable<string> CallLines(string call, int indent)
    {
        const string BeforeOption = " --";
        const int Continuation = 5;
        string line = new(' ', indent);
        foreach (string part in call.Split(BeforeOption).Select((part, index) => index == 0 ? part : BeforeOption + part))
        {
            if (line.Length + part.Length + " \\".Length > Width && line.Length > indent)
            {
                yield return $"{line} \\";
                line = new string(' ', indent + Continuation - 1);
            }

            line += part;
        }

        yield return line;
    }
}
