namespace Msisf.Adapters.Input;

/// <summary>A YAML file of settings, or one of its sections: typed values by key. Every error names file, line and column.</summary>
public sealed class SettingsSection
{
    private readonly string _fileName;
    private readonly string _what;
    private readonly (int Line, int Column) _place;
    private readonly IReadOnlyList<ConfigEntry> _entries;

    /// <summary>Takes the keys and refuses unknown ones.</summary>
    /// <param name="fileName">For messages.</param>
    /// <param name="what">What the keys belong to, for messages, e.g. "a camera".</param>
    /// <param name="place">Where the section begins.</param>
    /// <param name="entries">What was read.</param>
    /// <param name="keys">The keys that the section may have.</param>
    /// <exception cref="BadInputException">A key is none of these.</exception>
    public SettingsSection(
        string fileName, string what, (int Line, int Column) place, IReadOnlyList<ConfigEntry> entries, IReadOnlyList<string> keys)
    {
        (_fileName, _what, _place, _entries) = (fileName, what, place, entries);
        if (entries.FirstOrDefault(entry => !keys.Contains(entry.Key)) is { } unknown)
        {
            throw At(unknown, $"{NumberText.Shown(unknown.Key)} is not a key of {what}"
                + NearestName.Question(unknown.Key, keys, otherwise: $"; there are {string.Join(", ", keys)}"));
        }
    }

    /// <summary>Whether a key is there.</summary>
    public bool Has(string key) => Find(key) is not null;

    /// <summary>Whether a key has a list.</summary>
    public bool IsList(string key) => Find(key) is { IsList: true };

    /// <summary>A section below this one; null if it is not there.</summary>
    /// <param name="what">What its keys belong to, for messages, e.g. "a distortion".</param>
    /// <param name="keys">The keys that it may have.</param>
    /// <exception cref="BadInputException">There is a value in its place, or a key is none of these.</exception>
    public SettingsSection? Section(string key, string what, IReadOnlyList<string> keys) => Find(key) switch
    {
        null => null,
        { Entries: { } entries } entry => new SettingsSection(_fileName, what, (entry.Line, entry.Column), entries, keys),
        { } entry => throw At(entry, $"'{key}' is a section: put its keys below it, each in a line of its own and indented"),
    };

    /// <summary>The sections below a key, whose names are free; null if it is not there.</summary>
    /// <inheritdoc cref="Section"/>
    public IReadOnlyList<(string Name, SettingsSection Section)>? Sections(string key, string what, IReadOnlyList<string> keys) =>
        Find(key) switch
        {
            null => null,
            { Entries: { } entries } => [.. entries.Select(entry => (entry.Key, entry.Entries is { } own
                ? new SettingsSection(_fileName, what, (entry.Line, entry.Column), own, keys)
                : throw At(
                    entry, $"{NumberText.Shown(entry.Key)} is {what}: put its keys below it, each in a line of its own and indented")))],
            { } entry => throw At(entry, $"'{key}' is a section: put names below it, each in a line of its own and indented"),
        };

    /// <summary>The text of a key; null if it is not there.</summary>
    /// <exception cref="BadInputException">It has a list or a section.</exception>
    public string? Text(string key) => Find(key) is { } entry ? Single(entry) : null;

    /// <summary>The texts of a list, or a single one; null if the key is not there.</summary>
    /// <exception cref="BadInputException">It has a section.</exception>
    public IReadOnlyList<string>? Texts(string key) => Find(key) is { } entry
        ? entry.Entries is null ? entry.Values : throw NotASection(entry)
        : null;

    /// <summary>One word of several.</summary>
    /// <param name="words">The words that it may be.</param>
    /// <returns>Null if the key is not there.</returns>
    /// <exception cref="BadInputException">It is another word.</exception>
    public string? Word(string key, IReadOnlyList<string> words)
    {
        string? word = Text(key);
        return word is null || words.Contains(word)
            ? word
            : throw Wrong(key, $"'{key}' is {NumberText.Shown(word)}; one of {string.Join(", ", words)} is needed"
                + NearestName.Question(word, words));
    }

    /// <summary>A number; null if the key is not there.</summary>
    /// <exception cref="BadInputException">It is not a number.</exception>
    public double? Number(string key) => Find(key) is { } entry ? Parse(entry, Single(entry)) : null;

    /// <summary>A number above 0; null if the key is not there.</summary>
    /// <exception cref="BadInputException">It is not a number, zero or negative.</exception>
    public double? Positive(string key) => Number(key) is not double number || number > 0.0
        ? Number(key)
        : throw Wrong(key, $"'{key}' is {Text(key)}; a number above 0 is needed");

    /// <summary>A whole number; null if the key is not there.</summary>
    /// <param name="min">Minimum.</param>
    /// <param name="max">Maximum.</param>
    /// <exception cref="BadInputException">It is not a whole number, or out of range.</exception>
    public int? Whole(string key, int min, int max) => Number(key) is not double number
        ? null
        : number >= min && number <= max && number == Math.Floor(number)
            ? (int)number
            : throw Wrong(key, $"'{key}' is {Text(key)}; a whole number from {min} to {max} is needed");

    /// <summary>The numbers of a list, or a single one; null if the key is not there.</summary>
    /// <param name="min">How many there must be at least.</param>
    /// <param name="max">How many there may be.</param>
    /// <exception cref="BadInputException">There are too few or too many, or one is not a number.</exception>
    public double[]? Numbers(string key, int min, int max)
    {
        if (Find(key) is not { } entry)
        {
            return null;
        }

        int count = entry.Entries is null ? entry.Values.Count : throw NotASection(entry);
        return count >= min && count <= max
            ? [.. entry.Values.Select(text => Parse(entry, text))]
            : throw At(entry, $"'{key}' has {count} {(count == 1 ? "number" : "numbers")}; "
                + $"{(min == max ? $"{min}" : $"{min} to {max}")} {(max == 1 ? "is" : "are")} needed");
    }

    /// <summary>The error that a key is not there.</summary>
    /// <param name="meaning">What it gives, for messages, e.g. "the image's width in px".</param>
    public BadInputException Missing(string key, string meaning) =>
        new($"{_fileName}, line {_place.Line}, column {_place.Column}: {_what} needs '{key}': {meaning}.");

    /// <summary>The error that a key's value is wrong.</summary>
    /// <param name="key">The key; the section's place is named if it is not there.</param>
    /// <param name="why">What is wrong and what to do, without the full stop.</param>
    public BadInputException Wrong(string key, string why) => Find(key) is { } entry ? At(entry, why) : Here(why);

    /// <summary>The error that the section itself is wrong.</summary>
    /// <param name="why">What is wrong and what to do, without the full stop.</param>
    public BadInputException Here(string why) =>
        new($"{_fileName}, line {_place.Line}, column {_place.Column}: {why}.");

    private ConfigEntry? Find(string key) => _entries.FirstOrDefault(entry => entry.Key == key);

    private string Single(ConfigEntry entry) => entry switch
    {
        { Entries: not null } => throw NotASection(entry),
        { IsList: true } => throw At(entry, $"'{entry.Key}' takes one value, not a list. Leave the brackets or the dashes out"),
        _ => entry.Values[0],
    };

    private double Parse(ConfigEntry entry, string text) => NumberText.TryParse(text, out double value)
        ? value
        : throw At(entry, $"'{entry.Key}': {NumberText.ProblemWith(text)}");

    private BadInputException NotASection(ConfigEntry entry) =>
        At(entry, $"'{entry.Key}' takes a value; nothing can be below it");

    private BadInputException At(ConfigEntry entry, string why) =>
        new($"{_fileName}, line {entry.Line}, column {entry.Column}: {why}{(why.EndsWith('?') ? string.Empty : ".")}");
}
