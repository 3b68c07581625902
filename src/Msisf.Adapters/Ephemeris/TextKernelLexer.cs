using System.Text;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Cuts the data of a text kernel (what is between \begindata and \begintext) into tokens.</summary>
internal static class TextKernelLexer
{
    private const string BeginData = "\\begindata";
    private const string BeginText = "\\begintext";

    /// <summary>All tokens of a file.</summary>
    /// <exception cref="BadInputException">No \begindata, or a quote without its end.</exception>
    public static List<TextKernelToken> Read(TextReader reader, string fileName)
    {
        List<TextKernelToken> tokens = [];
        bool hasData = false;
        bool inData = false;
        int lineNumber = 0;
        while (reader.ReadLine() is { } line)
        {
            lineNumber++;
            switch (line.Trim())
            {
                case BeginData:
                    hasData = true;
                    inData = true;
                    break;
                case BeginText:
                    inData = false;
                    break;
                default:
                    if (inData)
                    {
                        ReadLine(line, lineNumber, fileName, tokens);
                    }

                    break;
            }
        }

        return hasData
            ? tokens
            : throw new BadInputException($"{fileName}: there is no line \\begindata, so this is not a SPICE text kernel with data.");
    }

    private static void ReadLine(string line, int lineNumber, string fileName, List<TextKernelToken> tokens)
    {
        int position = 0;
        while (position < line.Length)
        {
            char character = line[position];
            if (char.IsWhiteSpace(character) || character == ',')
            {
                position++;
                continue;
            }

            TextKernelTokenKind kind = character switch
            {
                '=' => TextKernelTokenKind.Assign,
                '(' => TextKernelTokenKind.Open,
                ')' => TextKernelTokenKind.Close,
                '\'' => TextKernelTokenKind.Text,
                _ => IsAppend(line, position) ? TextKernelTokenKind.Append : TextKernelTokenKind.Word,
            };
            int end = kind switch
            {
                TextKernelTokenKind.Append => position + 2,
                TextKernelTokenKind.Word => EndOfWord(line, position),
                TextKernelTokenKind.Text => EndOfText(line, position, lineNumber, fileName),
                _ => position + 1,
            };
            string value = kind == TextKernelTokenKind.Text
                ? new StringBuilder(line, position + 1, end - position - 2, end - position).Replace("''", "'").ToString()
                : line[position..end];
            tokens.Add(new TextKernelToken(kind, value, lineNumber));
            position = end;
        }
    }

    private static bool IsAppend(string line, int position) =>
        line[position] == '+' && position + 1 < line.Length && line[position + 1] == '=';

    private static int EndOfWord(string line, int start)
    {
        int end = start + 1;
        while (end < line.Length && !char.IsWhiteSpace(line[end]) && !"=(),'".Contains(line[end], StringComparison.Ordinal)
            && !IsAppend(line, end))
        {
            end++;
        }

        return end;
    }

    private static int EndOfText(string line, int start, int lineNumber, string fileName)
    {
        int end = start + 1;
        while (end < line.Length)
        {
            if (line[end] != '\'')
            {
                end++;
            }
            else if (end + 1 < line.Length && line[end + 1] == '\'')
            {
                end += 2;
            }
            else
            {
                return end + 1;
            }
        }

        throw new BadInputException(
            $"{fileName}, line {lineNumber}: the quote that opens at column {start + 1} is not closed on its line.");
    }
}

/// <summary>The kind of a token.</summary>
internal enum TextKernelTokenKind
{
    /// <summary>A name, a number or a date.</summary>
    Word,

    /// <summary>A text in quotes, without them.</summary>
    Text,

    Assign,

    Append,

    /// <summary>(</summary>
    Open,

    /// <summary>)</summary>
    Close,
}

/// <summary>A token of a text kernel's data. A class, because lists of it need no compilation at start-up.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Value">Its characters; a text's without quotes.</param>
/// <param name="Line">Its line in the file, from 1.</param>
internal sealed record TextKernelToken(TextKernelTokenKind Kind, string Value, int Line);
