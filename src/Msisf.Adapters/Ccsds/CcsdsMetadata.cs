using Msisf.Adapters.Input;

namespace Msisf.Adapters.Ccsds;

/// <summary>The keywords of one block of a file.</summary>
/// <param name="known">All keywords that a block may have, in their order.</param>
/// <param name="place">Where the reader is.</param>
internal sealed class CcsdsMetadata(string[] known, CcsdsPlace place)
{
    private readonly Dictionary<string, (string Value, int Line)> _values = [];
    private int _last = -1;

    /// <summary>Takes a keyword.</summary>
    /// <param name="written">The keyword as the file has it.</param>
    public void Add(string written, string value)
    {
        string key = written.ToUpperInvariant();
        int index = Array.IndexOf(known, key);
        if (index < 0)
        {
            string question = NearestName.Question(key, known);
            if (question.Length > 0)
            {
                throw place.Error($"there is no keyword {NumberText.Shown(written)}{question}");
            }

            place.Note($"The keyword {NumberText.Shown(written)} is not known; it is left out.");
            return;
        }

        if (_values.TryGetValue(key, out (string Value, int Line) before))
        {
            if (before.Value != value)
            {
                throw place.Error($"{key} is in line {before.Line} too, with another value. Remove one of them.");
            }

            return;
        }

        if (index < _last)
        {
            place.Note("The keywords are not in the order of the standard; other programs may refuse the file.");
        }

        _last = Math.Max(_last, index);
        _values.Add(key, (value, place.Line));
    }

    /// <summary>A value; null if the block has none.</summary>
    public string? Find(string key) => _values.TryGetValue(key, out (string Value, int Line) found) ? found.Value : null;

    /// <summary>A value that must be there.</summary>
    /// <param name="key">The keyword.</param>
    /// <param name="what">What it says, for the message.</param>
    public string Require(string key, string what) =>
        Find(key) is { Length: > 0 } value ? value : throw place.Error($"the block above has no {key}: {what}. Add it.");

    /// <summary>The error for a value.</summary>
    /// <param name="key">The keyword, which the block has.</param>
    /// <param name="problem">What is wrong, and what to do.</param>
    public Exception Error(string key, string problem)
    {
        place.Line = _values[key].Line;
        return place.Error($"{key} = {NumberText.Shown(_values[key].Value)}: {problem}");
    }
}

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

    /// <summary>Reads a number; the D of Fortran's exponents is read as E, and noted.</summary>
    /// <param name="text">Its characters alone.</param>
    public double Number(ReadOnlySpan<char> text)
    {
        if (NumberText.TryParse(text, out double number))
        {
            return number;
        }

        if (text.IndexOfAny('D', 'd') is > 0 and int exponent
            && NumberText.TryParse($"{text[..exponent]}E{text[(exponent + 1)..]}", out number))
        {
            Note("Numbers have Fortran's D for the exponent; it is read as E.");
            return number;
        }

        throw Error($"{NumberText.ProblemWith(text)}.");
    }

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
