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
                throw place.Error($"{key} stands in line {before.Line} too, with another value. Remove one of them.");
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
