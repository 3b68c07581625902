using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Pds;

/// <summary>Cuts the text of a PDS3 label (Object Description Language) into tokens, comments left out.</summary>
/// <remarks>Planetary Data System Standards Reference 3.8, chapter 12.</remarks>
internal sealed class PdsTokenizer
{
    private const string Signs = "=(){},";

    private readonly string _text;
    private readonly string _file;
    private int _position;
    private int _line = 1;

    /// <summary>Starts at the beginning of a label.</summary>
    /// <param name="text">The label; what follows its END may be anything.</param>
    /// <param name="file">Name for messages.</param>
    public PdsTokenizer(string text, string file)
    {
        _text = text;
        _file = file;
    }

    /// <summary>The next token.</summary>
    /// <exception cref="BadInputException">A quotation, comment or unit has no end.</exception>
    public PdsToken Next()
    {
        SkipBlanksAndComments();
        if (_position >= _text.Length)
        {
            return new PdsToken(PdsTokenKind.End, string.Empty, _line);
        }

        char first = _text[_position];
        return first switch
        {
            '"' or '\'' => Enclosed(PdsTokenKind.Quoted, first, "quotation"),
            '<' => Enclosed(PdsTokenKind.Unit, '>', "unit"),
            _ when Signs.Contains(first, StringComparison.Ordinal) =>
                new PdsToken(PdsTokenKind.Sign, _text.Substring(_position++, 1), _line),
            _ => Word(),
        };
    }

    private void SkipBlanksAndComments()
    {
        while (_position < _text.Length)
        {
            if (IsBlank(_text[_position]))
            {
                CountLine(_text[_position++]);
            }
            else if (IsCommentStart(_position))
            {
                int end = _text.IndexOf("*/", _position + 2, StringComparison.Ordinal);
                MoveTo(end < 0 ? throw Endless("comment", _line) : end + 2);
            }
            else
            {
                return;
            }
        }
    }

    private PdsToken Enclosed(PdsTokenKind kind, char closing, string what)
    {
        int startLine = _line;
        int start = _position + 1;
        int end = _text.IndexOf(closing, start);
        MoveTo(end < 0 ? throw Endless(what, startLine) : end + 1);
        return new PdsToken(kind, _text[start..end], startLine);
    }

    private PdsToken Word()
    {
        int start = _position;
        while (_position < _text.Length && !IsWordEnd(_text[_position]) && !IsCommentStart(_position))
        {
            _position++;
        }

        return new PdsToken(PdsTokenKind.Word, _text[start.._position], _line);
    }

    private void MoveTo(int target)
    {
        while (_position < target)
        {
            CountLine(_text[_position++]);
        }
    }

    private void CountLine(char character) => _line += character == '\n' ? 1 : 0;

    private bool IsCommentStart(int index) => _text.AsSpan(index).StartsWith("/*", StringComparison.Ordinal);

    private BadInputException Endless(string what, int startLine) => new(string.Create(
        CultureInfo.InvariantCulture, $"{_file}, line {startLine}: the {what} that begins here has no end. Is this a whole PDS3 label?"));

    private static bool IsBlank(char character) => char.IsWhiteSpace(character) || character == '\0';

    private static bool IsWordEnd(char character) =>
        IsBlank(character) || character is '"' or '\'' or '<' || Signs.Contains(character, StringComparison.Ordinal);
}
