namespace Msisf.Cli.Help;

/// <summary>Breaks text into lines for a terminal of 80 columns.</summary>
internal static class TextLayout
{
    /// <summary>Columns of a line, but for the last one, at which some terminals break.</summary>
    public const int Width = 79;

    /// <summary>Lines of a text, each indented; a word longer than a line has one of its own.</summary>
    /// <param name="text">Words, separated by blanks.</param>
    /// <param name="indent">Columns before each line.</param>
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

    /// <summary>Lines of a call of the program, continued by a backslash before an option.</summary>
    /// <param name="call">The call.</param>
    /// <param name="indent">Columns before the first line.</param>
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
