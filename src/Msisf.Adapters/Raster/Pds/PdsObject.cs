namespace Msisf.Adapters.Raster.Pds;

/// <summary>A value of a PDS3 label: one text, or a sequence or set of values.</summary>
/// <param name="Text">The text without quotes; empty for a sequence or set.</param>
/// <param name="IsQuoted">The text was in quotes, so it is not a number.</param>
/// <param name="Unit">Unit as written, e.g. "pix/deg"; null if none is given.</param>
/// <param name="Items">The values of a sequence or set; null for one text.</param>
/// <param name="Line">Line of the label, from 1.</param>
internal sealed record PdsValue(string Text, bool IsQuoted, string? Unit, IReadOnlyList<PdsValue>? Items, int Line)
{
    /// <summary>
    /// The text as a word of the standard: capitals, with one underscore for blanks, hyphens and underscores. "Band Sequential" is
    /// BAND_SEQUENTIAL.
    /// </summary>
    public string Word => WordOf(Text);

    /// <summary>A text as <see cref="Word"/> has it.</summary>
    public static string WordOf(string text) => string.Join('_', text.ToUpperInvariant().Split(
        (char[])[' ', '\t', '\r', '\n', '-', '_'], StringSplitOptions.RemoveEmptyEntries));

    /// <summary>As the label writes it, on one line.</summary>
    public override string ToString() => Items is null
        ? string.Join(' ', Text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)) + (Unit is null ? string.Empty : $" <{Unit}>")
        : $"({string.Join(", ", Items)})";
}

/// <summary>An OBJECT or GROUP of a PDS3 label, or the label itself: keywords with their values, and objects inside it.</summary>
/// <param name="file">Name of the label's file for messages.</param>
/// <param name="name">Name of the object, e.g. "IMAGE_MAP_PROJECTION".</param>
/// <param name="line">Line where it begins, from 1.</param>
/// <remarks>Names of keywords and objects are the same in small letters and in capitals.</remarks>
internal sealed class PdsObject(string file, string name, int line)
{
    private readonly Dictionary<string, PdsValue> _values = new(StringComparer.OrdinalIgnoreCase);
    private readonly Dictionary<string, PdsValue> _contradictions = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<PdsObject> _children = [];

    public string Name => name;

    public int Line => line;

    /// <summary>The value of a keyword of this object itself; null if it has none.</summary>
    /// <exception cref="BadInputException">The object has it twice, with values that contradict each other.</exception>
    public PdsValue? Find(string keyword) => _contradictions.TryGetValue(keyword, out PdsValue? second)
        ? throw WrongValue(keyword, second, $"line {_values[keyword].Line} of the same object says {_values[keyword]}")
        : _values.GetValueOrDefault(keyword);

    /// <summary>The first object of a name, in the order of the label, however deep; null if there is none.</summary>
    public PdsObject? FindObject(string wanted) => _children
        .Select(child => child.Name.Equals(wanted, StringComparison.OrdinalIgnoreCase) ? child : child.FindObject(wanted))
        .FirstOrDefault(found => found is not null);

    /// <summary>This object and all below it, in the order of the label.</summary>
    public IEnumerable<PdsObject> All => _children.SelectMany(child => child.All).Prepend(this);

    /// <summary>The keywords of this object itself, without those that it has twice with values that contradict each other.</summary>
    public IEnumerable<KeyValuePair<string, PdsValue>> Values => _values.Where(pair => !_contradictions.ContainsKey(pair.Key));

    /// <summary>The error for each keyword that the object has twice, with values that contradict each other.</summary>
    public IEnumerable<KeyValuePair<string, string>> Contradictions => _contradictions.Select(pair => KeyValuePair.Create(
        pair.Key, WrongValue(pair.Key, pair.Value, $"line {_values[pair.Key].Line} of the same object says {_values[pair.Key]}").Message));

    /// <summary>The value of a keyword that must be there.</summary>
    /// <exception cref="BadInputException">It is missing.</exception>
    public PdsValue Required(string keyword) => Find(keyword)
        ?? throw new BadInputException($"{file}: {name} has no {keyword}. Get the label again from the archive that holds the product.");

    /// <summary>The one-line text of a keyword that must be there.</summary>
    /// <exception cref="BadInputException">It is missing, empty or a sequence.</exception>
    public string RequiredText(string keyword)
    {
        PdsValue value = Required(keyword);
        return value.Items is null && value.Text.Length > 0 ? value.ToString() : throw WrongValue(keyword, "one text is needed");
    }

    /// <summary>
    /// The number of a keyword that must be there; its unit, if it has one, must be the given one of <see cref="PdsUnit"/>.
    /// </summary>
    /// <exception cref="BadInputException">It is missing, no finite number, or has another unit.</exception>
    public double RequiredNumber(string keyword, string? unit = null) => Number(keyword, Required(keyword), unit);

    /// <summary>The number of a keyword; null if it is missing or 'N/A'.</summary>
    /// <exception cref="BadInputException">It is not a finite number, or has another unit.</exception>
    public double? OptionalNumber(string keyword, string? unit = null) =>
        Find(keyword) is { } value && value.Word != "N/A" ? Number(keyword, value, unit) : null;

    /// <summary>The whole number of a keyword that must be there.</summary>
    /// <exception cref="BadInputException">It is missing, no whole number, or out of range.</exception>
    public int RequiredInteger(string keyword, int minimum, int maximum)
    {
        double number = Number(keyword, Required(keyword), unit: null);
        return number == Math.Floor(number) && number >= minimum && number <= maximum
            ? (int)number
            : throw WrongValue(keyword, $"a whole number from {minimum} to {maximum} is needed");
    }

    /// <summary>The whole number of a keyword; null if it is missing.</summary>
    /// <exception cref="BadInputException">It is not a whole number, or out of range.</exception>
    public int? OptionalInteger(string keyword, int minimum, int maximum) =>
        Find(keyword) is null ? null : RequiredInteger(keyword, minimum, maximum);

    /// <summary>Checks that a word, if the label has it, is the expected one.</summary>
    /// <exception cref="BadInputException">It is another one.</exception>
    public void CheckText(string keyword, string expected, string need)
    {
        if (Find(keyword) is { } value && value.Word != PdsValue.WordOf(expected))
        {
            throw WrongValue(keyword, need);
        }
    }

    /// <summary>Checks that a number, if the label has it, is the expected one.</summary>
    /// <exception cref="BadInputException">It is another one.</exception>
    public void CheckNumber(string keyword, double expected, string? unit = null)
    {
        if (OptionalNumber(keyword, unit) is { } number && number != expected)
        {
            throw WrongValue(keyword, Invariant($"the rest of the label needs {expected:R}"));
        }
    }

    /// <summary>The error for the value of a keyword that must be there.</summary>
    /// <param name="need">What is needed instead.</param>
    public BadInputException WrongValue(string keyword, string need) => WrongValue(keyword, Required(keyword), need);

    /// <summary>The error for a value, or for a part of it.</summary>
    public BadInputException WrongValue(string keyword, PdsValue value, string need) =>
        new($"{file}, line {value.Line}: {keyword} = {value}; {need}.");

    /// <summary>Adds a keyword while the label is read. A second value counts only when somebody asks for the keyword.</summary>
    public void Add(string keyword, PdsValue value)
    {
        if (!_values.TryAdd(keyword, value) && _values[keyword].ToString() != value.ToString())
        {
            _contradictions.TryAdd(keyword, value);
        }
    }

    /// <summary>Adds an object while the label is read.</summary>
    public void Add(PdsObject child) => _children.Add(child);

    private double Number(string keyword, PdsValue value, string? unit) =>
        value.Items is not null || value.IsQuoted || !double.TryParse(
            value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || !double.IsFinite(number)
            ? throw WrongValue(keyword, value, "a finite number is needed")
            : unit is null || value.Unit is null || PdsUnit.Of(value.Unit) == unit
                ? number
                : throw WrongValue(keyword, value, $"the unit <{unit}> is needed");
}

/// <summary>Checks that the labels of one product's files say the same.</summary>
internal static class PdsAgreement
{
    /// <summary>Requires that keywords have the same values in all labels.</summary>
    /// <param name="labels">The labels; at least one.</param>
    /// <param name="file">What each file is, e.g. "part".</param>
    /// <param name="whole">What they make up, e.g. "model".</param>
    /// <param name="keywords">The keywords, and the value that a label has for each.</param>
    /// <exception cref="BadInputException">Two values differ.</exception>
    public static void Require<TLabel>(
        IReadOnlyList<TLabel> labels, Func<TLabel, string> pathOf, string file, string whole,
        params IReadOnlyList<(string Keyword, Func<TLabel, object> Of)> keywords)
    {
        TLabel first = labels[0];
        foreach (TLabel other in labels.Skip(1))
        {
            if (keywords.FirstOrDefault(one => !one.Of(first).Equals(one.Of(other))) is { Of: { } of } differing)
            {
                throw new BadInputException(Invariant(
                    $"{pathOf(other)}: {differing.Keyword} is {of(other)}, but {of(first)} in {pathOf(first)}, another {file} of "
                        + $"the same {whole}. Get all {file}s of one release."));
            }
        }
    }
}

/// <summary>The place of the samples that a label's ^IMAGE names.</summary>
/// <param name="FileName">Name of the image's file beside the label; null for an attached label, whose file holds both.</param>
/// <param name="Offset">Bytes of that file before the first sample.</param>
internal readonly record struct PdsImagePointer(string? FileName, long Offset)
{
    private const string Keyword = "^IMAGE";

    /// <summary>
    /// Reads ^IMAGE = "FILE", ("FILE", record), ("FILE", byte &lt;BYTES&gt;), record, or byte &lt;BYTES&gt;; both count from 1.
    /// </summary>
    /// <param name="holder">The object that has ^IMAGE.</param>
    /// <param name="recordBytes">RECORD_BYTES; null if the label has none.</param>
    /// <exception cref="BadInputException">^IMAGE is missing or of another form.</exception>
    public static PdsImagePointer Read(PdsObject holder, int? recordBytes)
    {
        PdsValue pointer = holder.Required(Keyword);
        return (pointer.Items ?? [pointer]) switch
        {
            [{ IsQuoted: true } file] => new PdsImagePointer(PlainName(file), Offset: 0),
            [{ IsQuoted: true } file, var place] => new PdsImagePointer(PlainName(file), OffsetOf(place)),
            [var place] when pointer.Items is null => new PdsImagePointer(FileName: null, OffsetOf(place)),
            _ => throw holder.WrongValue(Keyword, "a file name, a place, or both are needed"),
        };

        string PlainName(PdsValue file) =>
            file.Text.Length > 0 && file.Text.IndexOfAny(['/', '\\', ':']) < 0 && !file.Text.Any(char.IsControl)
                ? file.Text
                : throw holder.WrongValue(Keyword, file, "the plain name of a file beside the label is needed");

        long OffsetOf(PdsValue place) =>
            place.IsQuoted || !uint.TryParse(place.Text, out uint number) || number == 0
                ? throw holder.WrongValue(Keyword, place, "a record or byte number from 1 is needed")
            : place.Unit is null ? (number - 1L)
                * (recordBytes ?? throw holder.WrongValue(Keyword, place, "the label has no RECORD_BYTES to count records with"))
            : string.Equals(place.Unit, "BYTES", StringComparison.OrdinalIgnoreCase) ? number - 1L
            : throw holder.WrongValue(Keyword, place, "the unit <BYTES> or none is needed");
    }

    /// <summary>Path of the image's file.</summary>
    public string PathBeside(string labelPath) =>
        FileName is null ? labelPath : Path.Combine(Path.GetDirectoryName(labelPath) ?? string.Empty, FileName);
}
