using System.Buffers;

namespace Msisf.Adapters.Input;

/// <summary>Reads the lines of a text with memory for the longest allowed line only, and refuses what can't be text.</summary>
/// <param name="reader">The text; LF or CRLF ends a line, a byte order mark at the start is left out.</param>
/// <param name="fileName">For messages.</param>
internal sealed class BoundedLineReader(TextReader reader, string fileName)
{
    /// <summary>Characters. A line of numbers has some 200; a longer line belongs to another kind of file.</summary>
    public const int LongestLine = 65_536;

    private static readonly SearchValues<char> NeverInText =
        SearchValues.Create([.. Enumerable.Range(0, 32).Select(code => (char)code).Except("\t\v\f\r"), '\x7F']);

    private readonly char[] _buffer = new char[LongestLine + 1];
    private int _start;
    private int _end;
    private bool _isAtEnd;

    /// <summary>Number of the line read last, from 1.</summary>
    public int LineNumber { get; private set; }

    /// <summary>Reads the next line.</summary>
    /// <param name="line">The line without its end; valid until the next call.</param>
    /// <returns>False at the end of the text.</returns>
    /// <exception cref="BadInputException">The line is too long or holds control characters.</exception>
    public bool TryRead(out ReadOnlySpan<char> line)
    {
        line = default;
        int length = LengthOfNextLine();
        if (length < 0)
        {
            return false;
        }

        LineNumber++;
        line = _buffer.AsSpan(_start, length);
        _start = Math.Min(_end, _start + length + 1);

        int control = line.IndexOfAny(NeverInText);
        if (control >= 0)
        {
            throw new BadInputException(
                $"{fileName}, line {LineNumber}, column {control + 1}: control character U+{(int)line[control]:X4}; "
                    + $"this is not a text file.");
        }

        line = LineNumber == 1 ? line.TrimStart('\uFEFF') : line;
        return true;
    }

    private int LengthOfNextLine()
    {
        int searched = 0;
        while (true)
        {
            int feed = _buffer.AsSpan((_start + searched).._end).IndexOf('\n');
            if (feed >= 0)
            {
                return searched + feed;
            }

            searched = _end - _start;
            if (_isAtEnd)
            {
                return searched > 0 ? searched : -1;
            }

            Fill();
        }
    }

    private void Fill()
    {
        _buffer.AsSpan(_start.._end).CopyTo(_buffer);
        (_start, _end) = (0, _end - _start);
        if (_end == _buffer.Length)
        {
            throw new BadInputException(
                $"{fileName}, line {LineNumber + 1}: longer than {LongestLine} characters; this is not a file of numbers in lines.");
        }

        int read = reader.Read(_buffer, _end, _buffer.Length - _end);
        _isAtEnd = read == 0;
        _end += read;
    }
}
