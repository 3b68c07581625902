namespace Msisf.Adapters.Ccsds;

/// <summary>Where in a file a reader is, for its errors and notes.</summary>
internal sealed class CcsdsPlace(string fileName)
{
    private readonly Dictionary<string, (int Line, int Count)> _notes = [];

    public string FileName => fileName;

    /// <summary>The line that is read, from 1.</summary>
    public int Line { get; set; }

    /// <summary>What was put right while reading, each once.</summary>
    public IEnumerable<string> Notes => _notes.Select(note => Invariant(
        $"{fileName}, line {note.Value.Line}: {note.Key}{(note.Value.Count > 1 ? $" So {note.Value.Count} times." : string.Empty)}"));

    /// <summary>Notes something that is wrong, but can be meant in one way only.</summary>
    /// <param name="text">One sentence.</param>
    public void Note(string text) => _notes[text] = _notes.TryGetValue(text, out (int Line, int Count) known)
        ? (known.Line, known.Count + 1)
        : (Line, 1);

    /// <summary>The error for the line.</summary>
    /// <param name="problem">What is wrong, and what to do.</param>
    /// <param name="inner">The exception behind it, if there is one.</param>
    public BadInputException Error(string problem, Exception? inner = null) =>
        new(Invariant($"{fileName}, line {Line}: {problem}"), inner);

    /// <summary>Does something whose errors do not say where they are.</summary>
    /// <typeparam name="T">Type of the result.</typeparam>
    /// <exception cref="BadInputException">It failed; the message begins with file and line.</exception>
    public T Located<T>(Func<T> work)
    {
        try
        {
            return work();
        }
        catch (BadInputException exception) when (!exception.Message.StartsWith(fileName, StringComparison.Ordinal))
        {
            throw Error(exception.Message, exception);
        }
    }
}
