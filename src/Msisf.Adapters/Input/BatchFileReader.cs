using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>
/// Reads batch files (thesis section 6.3.2): a line is one state, <c>MJD rx ry rz qx qy qz q0</c>, the numbers apart by blanks or tabs,
/// and <c>vx vy vz wx wy wz</c> after them if the camera's motion is known; or, after a line of column names apart by commas, the values
/// of these columns. "#" begins a comment; empty lines are allowed. A comment <c># msis: frame=j2000</c> above them says how the numbers
/// are meant.
/// </summary>
public static class BatchFileReader
{
    /// <summary>Reads all states; nothing is returned before every line was read and is right.</summary>
    /// <param name="reader">The text, read once from start to end; about 2 microseconds and 64 bytes a line.</param>
    /// <param name="fileName">For messages, e.g. "input/run7.tab".</param>
    /// <param name="scene">Terrain, Sun and the Moon's turning; asked only by columns and frames that refer to them.</param>
    /// <param name="conventions">How the numbers are meant, as far as the file does not say it; null for the thesis's way.</param>
    /// <param name="warn">Receives a sentence about states that are right, but most likely not meant.</param>
    /// <param name="note">Receives a sentence about how columns were understood.</param>
    /// <returns>The states in the order of their lines; none if there are only comments.</returns>
    /// <exception cref="BadInputException">The first line that is wrong, by file, line and column; or not a text file.</exception>
    /// <exception cref="ExternalPartException">The file can't be read.</exception>
    public static IReadOnlyList<SpacecraftState> Read(
        TextReader reader, string fileName, ISceneGeometry scene, BatchConventions? conventions = null, Action<string>? warn = null,
        Action<string>? note = null)
    {
        BoundedLineReader lines = new(reader, fileName);
        BatchFileParser parser = new(scene, conventions ?? new BatchConventions());
        try
        {
            while (lines.TryRead(out ReadOnlySpan<char> line))
            {
                parser.Take(line, lines.LineNumber);
            }
        }
        catch (BadInputException exception) when (!exception.Message.StartsWith($"{fileName}, line ", StringComparison.Ordinal))
        {
            string separator = exception.Message.StartsWith(", column ", StringComparison.Ordinal) ? string.Empty : ": ";
            throw new BadInputException($"{fileName}, line {lines.LineNumber}{separator}{exception.Message}", exception);
        }
        catch (IOException exception)
        {
            throw new ExternalPartException($"{fileName}: can't be read after line {lines.LineNumber}: {exception.Message}", exception);
        }

        BatchNotes.Write(parser, fileName, scene, warn, note);
        return parser.States;
    }
}

/// <summary>Takes the lines of a batch file one after another.</summary>
/// <param name="scene">Terrain, Sun and the Moon's turning.</param>
/// <param name="conventions">How the numbers are meant, as far as the file does not say it.</param>
internal sealed class BatchFileParser(ISceneGeometry scene, BatchConventions conventions)
{
    private const string ExampleHeader = "time,lat,lon,height";

    private static readonly string Expected = string.Join(' ', SpacecraftState.NumberNames);

    private readonly List<SpacecraftState> _states = [];
    private BatchConventions _said = conventions;
    private BatchFrame? _frame;

    /// <summary>The states so far.</summary>
    public IReadOnlyList<SpacecraftState> States => _states;

    /// <summary>The named columns; null if there are none.</summary>
    public BatchColumns? Columns { get; private set; }

    /// <summary>What makes states of the named columns; null if there are none.</summary>
    public BatchStates? ColumnStates { get; private set; }

    /// <summary>Takes a line.</summary>
    /// <param name="line">The line without its end.</param>
    /// <param name="lineNumber">Its number, from 1.</param>
    /// <exception cref="BadInputException">It is wrong; the message is to follow the number of the line.</exception>
    public void Take(ReadOnlySpan<char> line, int lineNumber)
    {
        int comment = line.IndexOf('#');
        ReadOnlySpan<char> content = (comment < 0 ? line : line[..comment]).TrimEnd();
        if (comment >= 0 && BatchKeyLine.IsOne(line[(comment + 1)..]))
        {
            if (!content.IsWhiteSpace() || _frame is not null)
            {
                throw new BadInputException(
                    "a '# msis:' line is a line of its own, above the names of the columns and the states. Move it there.");
            }

            _said = BatchKeyLine.Add(line[(comment + 1)..], _said);
        }

        if (content.IsWhiteSpace())
        {
            return;
        }

        if (_frame is null && Begin(content))
        {
            return;
        }

        _states.Add(ColumnStates is null ? ParseState(content) : ColumnStates.Read(content, lineNumber));
    }

    /// <summary>Takes the first line that is not a comment.</summary>
    /// <returns>Whether it names columns, so that it is not a state.</returns>
    private bool Begin(ReadOnlySpan<char> content)
    {
        bool isHeader = BatchColumns.IsHeader(content);
        Columns = isHeader ? new BatchColumns(content.ToString(), _said.IgnoresColumns) : null;
        new BatchRules(Columns, _said).Check();
        _frame = new BatchFrame(_said, scene);
        ColumnStates = Columns is null ? null : new BatchStates(Columns, _said, _frame, scene);
        return isHeader;
    }

    private SpacecraftState ParseState(ReadOnlySpan<char> content)
    {
        Span<double> numbers = stackalloc double[SpacecraftState.NumberNames.Count + CameraMotion.NumberNames.Count];
        CalendarTime time = default;
        int count = 0;
        int position = 0;
        while (TryNextWord(content, ref position, out ReadOnlySpan<char> word))
        {
            bool isTime = count == 0;
            double number = 0.0;
            if (isTime ? !TimeText.TryParse(word, out time) : !NumberText.TryParse(word, out number))
            {
                string problem = isTime ? TimeText.ProblemWith(word) : NumberText.ProblemWith(word);
                string header = word.Contains(',') ? $" Values apart by commas need a header line, e.g. {ExampleHeader}."
                    : BatchNames.Known(word.ToString()) is not null
                        ? $" Names of columns, and their values, are apart by commas, e.g. {ExampleHeader}."
                    : string.Empty;
                throw new BadInputException(
                    $", column {position - word.Length + 1}: {problem}. A line is: "
                        + $"{Expected}; comments begin with '#'.{header}");
            }

            if (count < numbers.Length)
            {
                numbers[count] = number;
            }

            count++;
        }

        int needed = SpacecraftState.NumberNames.Count;
        if (count != needed && count != numbers.Length)
        {
            throw new BadInputException(
                $"{count} numbers, {needed} expected ({Expected}). "
                    + $"{(count < needed ? "Complete" : "Shorten")} or remove the line.");
        }

        return BatchStates.Of(scene.TimeScale.InstantOf(time), numbers[1..count], _frame!);
    }

    private static bool TryNextWord(ReadOnlySpan<char> content, ref int position, out ReadOnlySpan<char> word)
    {
        while (position < content.Length && char.IsWhiteSpace(content[position]))
        {
            position++;
        }

        int start = position;
        while (position < content.Length && !char.IsWhiteSpace(content[position]))
        {
            position++;
        }

        word = content[start..position];
        return word.Length > 0;
    }
}
