using Msisf.Core.Attitude;
using Msisf.Core.Scene;

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
