using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Scene;

namespace Msisf.Adapters.Input;

/// <summary>
/// Reads batch files (thesis section 6.3.2): a line is one state, <c>MJD rx ry rz qx qy qz q0</c>, the numbers apart by blanks or tabs,
/// and <c>vx vy vz wx wy wz</c> after them if the camera's motion is known; or, after a line of column names apart by commas, the values
/// of these columns. "#" begins a comment; empty lines are allowed.
/// </summary>
public static class BatchFileReader
{
    private const string ExampleHeader = "time,lat,lon,height";

    private static readonly string Expected = string.Join(' ', SpacecraftState.NumberNames);

    /// <summary>Reads all states; nothing is returned before every line was read and is right.</summary>
    /// <param name="reader">The text, read once from start to end; about 2 microseconds and 64 bytes a line.</param>
    /// <param name="fileName">For messages, e.g. "input/run7.tab".</param>
    /// <param name="scene">Terrain and Sun; asked only by columns that refer to them.</param>
    /// <param name="warn">Receives a sentence about states that are right, but most likely not meant.</param>
    /// <returns>The states in the order of their lines; none if there are only comments.</returns>
    /// <exception cref="BadInputException">The first line that is wrong, by file, line and column; or not a text file.</exception>
    /// <exception cref="ExternalPartException">The file can't be read.</exception>
    public static IReadOnlyList<SpacecraftState> Read(
        TextReader reader, string fileName, ISceneGeometry scene, Action<string>? warn = null)
    {
        BoundedLineReader lines = new(reader, fileName);
        List<SpacecraftState> states = [];
        BatchColumns? columns = null;
        bool isFirst = true;
        try
        {
            while (lines.TryRead(out ReadOnlySpan<char> line))
            {
                int comment = line.IndexOf('#');
                ReadOnlySpan<char> content = (comment < 0 ? line : line[..comment]).TrimEnd();
                if (content.IsWhiteSpace())
                {
                    continue;
                }

                if (isFirst && BatchColumns.IsHeader(content))
                {
                    columns = new BatchColumns(content.ToString(), fileName, lines.LineNumber);
                }
                else
                {
                    states.Add(columns is null
                        ? ParseState(content, fileName, lines.LineNumber)
                        : columns.ReadState(content, lines.LineNumber, scene));
                }

                isFirst = false;
            }
        }
        catch (IOException exception)
        {
            throw new ExternalPartException($"{fileName}: can't be read after line {lines.LineNumber}: {exception.Message}", exception);
        }

        if (columns?.HiddenTargets is [int first, ..] hidden)
        {
            string rest = hidden.Count switch
            {
                1 => string.Empty,
                2 => " So it is in 1 more line.",
                _ => $" So it is in {hidden.Count - 1} more lines.",
            };
            warn?.Invoke($"{fileName}, line {first}: the place to look at {PointingText.Hidden}{rest}");
        }

        return states;
    }

    private static SpacecraftState ParseState(ReadOnlySpan<char> content, string fileName, int lineNumber)
    {
        Span<double> numbers = stackalloc double[SpacecraftState.NumberNames.Count + CameraMotion.NumberNames.Count];
        int count = 0;
        int position = 0;
        while (TryNextWord(content, ref position, out ReadOnlySpan<char> word))
        {
            bool isTime = count == 0;
            double number;
            if (isTime ? !TimeText.TryParse(word, out number) : !NumberText.TryParse(word, out number))
            {
                string problem = isTime ? TimeText.ProblemWith(word) : NumberText.ProblemWith(word);
                string header = word.Contains(',') ? $" Values apart by commas need a header line, e.g. {ExampleHeader}."
                    : BatchColumns.IsName(word) ? $" Names of columns, and their values, are apart by commas, e.g. {ExampleHeader}."
                    : string.Empty;
                throw new BadInputException(
                    $"{fileName}, line {lineNumber}, column {position - word.Length + 1}: {problem}. A line is: "
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
                $"{fileName}, line {lineNumber}: {count} numbers, {needed} expected ({Expected}). "
                    + $"{(count < needed ? "Complete" : "Shorten")} or remove the line.");
        }

        try
        {
            return SpacecraftState.FromNumbers(numbers[..count]);
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{fileName}, line {lineNumber}: {exception.Message}", exception);
        }
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
