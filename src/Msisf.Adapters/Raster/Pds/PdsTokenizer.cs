namespace Msisf.Adapters.Raster.Pds;

/// <summary>
/// What a piece of a PDS3 label is: a keyword or an unquoted value; a value in quotes; a unit in angle brackets; one of = ( ) { } and the
/// comma; the end of the text.
/// </summary>
internal enum PdsTokenKind { Word, Quoted, Unit, Sign, End }

/// <summary>A piece of a PDS3 label.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Text">Its text, without quotes or brackets.</param>
/// <param name="Line">Line of its first character, from 1.</param>
internal readonly record struct PdsToken(PdsTokenKind Kind, string Text, int Line)
{
    public bool IsSign(string sign) => Kind == PdsTokenKind.Sign && Text == sign;
}

/// <summary>Cuts the text of a PDS3 label (Object Description Language) into tokens, comments left out.</summary>
/// <remarks>Planetary Data System Standards Reference 3.8, chapter 12.</remarks>
/// <param name="text">The label; what follows its END may be anything.</param>
/// <param name="file">Name for messages.</param>
internal sealed class PdsTokenizer(string text, string file)
{
    private int _position;
    private int _line = 1;

    /// <summary>The next token.</summary>
    /// <exception cref="BadInputException">A quotation, comment or unit has no end.</exception>
    public PdsToken Next()
    {
        SkipBlanksAndComments();
        int line = _line;
        return _position == text.Length ? new PdsToken(PdsTokenKind.End, string.Empty, line) : text[_position] switch
        {
            '"' => new PdsToken(PdsTokenKind.Quoted, TakeTo("\"", 1, "quotation"), line),
            '\'' => new PdsToken(PdsTokenKind.Quoted, TakeTo("'", 1, "quotation"), line),
            '<' => new PdsToken(PdsTokenKind.Unit, TakeTo(">", 1, "unit"), line),
            var first when IsSign(first) => new PdsToken(PdsTokenKind.Sign, text.Substring(_position++, 1), line),
            _ => new PdsToken(PdsTokenKind.Word, TakeWord(), line),
        };
    }

    private void SkipBlanksAndComments()
    {
        while (_position < text.Length)
        {
            if (IsBlank(text[_position]))
            {
                _line += text[_position++] == '\n' ? 1 : 0;
            }
            else if (IsComment(_position))
            {
                TakeTo("*/", 2, "comment");
            }
            else
            {
                return;
            }
        }
    }

    /// <summary>What is before a closing sign, without the characters that open it.</summary>
    private string TakeTo(string closing, int opening, string what)
    {
        int start = _position + opening;
        int end = text.IndexOf(closing, start, StringComparison.Ordinal);
        if (end < 0)
        {
            throw new BadInputException(
                $"{file}, line {_line}: the {what} that begins here has no end. Is this a whole PDS3 label?");
        }

        _line += text.AsSpan(start, end - start).Count('\n');
        _position = end + closing.Length;
        return text[start..end];
    }

    /// <summary>A word; a hyphen at the end of a line joins it to the next one.</summary>
    private string TakeWord()
    {
        string word = string.Empty;
        while (true)
        {
            int start = _position;
            while (_position < text.Length && !IsBlank(text[_position]) && text[_position] is not ('"' or '\'' or '<')
                && !IsSign(text[_position]) && !IsComment(_position))
            {
                _position++;
            }

            word += text[start.._position];
            if (!(word.Length > 1 && word[^1] == '-' && _position < text.Length && text[_position] is '\r' or '\n'))
            {
                return word;
            }

            word = word[..^1];
            SkipBlanksAndComments();
        }
    }

    private bool IsComment(int index) => text.AsSpan(index).StartsWith("/*", StringComparison.Ordinal);

    private static bool IsBlank(char character) => char.IsWhiteSpace(character) || character == '\0';

    private static bool IsSign(char character) => character is '=' or '(' or ')' or '{' or '}' or ',';
}
