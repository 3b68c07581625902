using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Terrain.Pds;

/// <summary>Cuts the text of a PDS3 label (Object Description Language) into tokens, comments left out.</summary>
/// <remarks>Planetary Data System Standards Reference 3.8, chapter 12.</remarks>
internal sealed class PdsTokenizer
{
    private const string Signs = "=(){},";

    private readonly string text;
    private readonly string file;
    private int position;
    private int line = 1;

    /// <summary>Starts at the beginning of a label.</summary>
    /// <param name="text">The label; what follows its END may be anything.</param>
    /// <param name="file">Name for messages.</param>
    public PdsTokenizer(string text, string file)
    {
        this.text = text;
        this.file = file;
    }

    /// <summary>The next token.</summary>
    /// <exception cref="BadInputException">A quotation, comment or unit has no end.</exception>
    public PdsToken Next()
    {
        SkipBlanksAndComments();
        if (position >= text.Length)
        {
            return new PdsToken(PdsTokenKind.End, string.Empty, line);
        }

        char first = text[position];
        return first switch
        {
            '"' or '\'' => Enclosed(PdsTokenKind.Quoted, first, "quotation"),
            '<' => Enclosed(PdsTokenKind.Unit, '>', "unit"),
            _ when Signs.Contains(first, StringComparison.Ordinal) => new PdsToken(PdsTokenKind.Sign, text.Substring(position++, 1), line),
            _ => Word(),
        };
    }

    private void SkipBlanksAndComments()
    {
        while (position < text.Length)
        {
            if (IsBlank(text[position]))
            {
                CountLine(text[position++]);
            }
            else if (IsCommentStart(position))
            {
                int end = text.IndexOf("*/", position + 2, StringComparison.Ordinal);
                MoveTo(end < 0 ? throw Endless("comment", line) : end + 2);
            }
            else
            {
                return;
            }
        }
    }

    private PdsToken Enclosed(PdsTokenKind kind, char closing, string what)
    {
        int startLine = line;
        int start = position + 1;
        int end = text.IndexOf(closing, start);
        MoveTo(end < 0 ? throw Endless(what, startLine) : end + 1);
        return new PdsToken(kind, text[start..end], startLine);
    }

    private PdsToken Word()
    {
        int start = position;
        while (position < text.Length && !IsWordEnd(text[position]) && !IsCommentStart(position))
        {
            position++;
        }

        return new PdsToken(PdsTokenKind.Word, text[start..position], line);
    }

    private void MoveTo(int target)
    {
        while (position < target)
        {
            CountLine(text[position++]);
        }
    }

    private void CountLine(char character) => line += character == '\n' ? 1 : 0;

    private bool IsCommentStart(int index) => text.AsSpan(index).StartsWith("/*", StringComparison.Ordinal);

    private BadInputException Endless(string what, int startLine) => new(string.Create(
        CultureInfo.InvariantCulture, $"{file}, line {startLine}: the {what} that begins here has no end. Is this a whole PDS3 label?"));

    private static bool IsBlank(char character) => char.IsWhiteSpace(character) || character == '\0';

    private static bool IsWordEnd(char character) =>
        IsBlank(character) || character is '"' or '\'' or '<' || Signs.Contains(character, StringComparison.Ordinal);
}
