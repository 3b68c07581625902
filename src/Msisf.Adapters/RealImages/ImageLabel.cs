namespace Msisf.Adapters.RealImages;

/// <summary>What the label of a real image says: an ISIS cube, a PDS3 or a PDS4 product. Immutable.</summary>
/// <param name="path">The label's file.</param>
/// <param name="keywords">Its keywords by their names without underscores, in capitals.</param>
public sealed class ImageLabel(string path, IReadOnlyDictionary<string, LabelValue> keywords)
{
    /// <summary>The label's file.</summary>
    public string Path => path;

    /// <summary>What it is, e.g. "ISIS cube".</summary>
    public required string Kind { get; init; }

    /// <summary>Where the pixels are.</summary>
    public required PixelLayout Pixels { get; init; }

    /// <summary>Keywords of SPICE that a cube has taken over, by their names; empty for others.</summary>
    public IReadOnlyDictionary<string, LabelValue> Naif { get; init; } = new Dictionary<string, LabelValue>();

    /// <summary>The tables of a cube; null for other products.</summary>
    public CubeTables? Tables { get; init; }

    /// <summary>The errors for keywords that the label has twice, with values that contradict each other, by their names.</summary>
    public IReadOnlyDictionary<string, string> Contradictions { get; init; } = new Dictionary<string, string>();

    /// <summary>The name of a keyword as all kinds of labels share it: LRO:START_TIME, StartTime and start_time are STARTTIME.</summary>
    public static string NameOf(string keyword) =>
        keyword[(keyword.LastIndexOf(':') + 1)..].Replace("_", string.Empty, StringComparison.Ordinal).ToUpperInvariant();

    /// <summary>The value of a keyword; null if the label does not have it, or says that it is not known.</summary>
    /// <exception cref="BadInputException">The label has it twice, with values that contradict each other.</exception>
    public LabelValue? Find(string name) => Contradictions.TryGetValue(name, out string? error)
        ? throw new BadInputException(error)
        : keywords.TryGetValue(name, out LabelValue? value)
        && !value.Text.Equals("NULL", StringComparison.OrdinalIgnoreCase) && value.Text is not ("N/A" or "UNK") ? value : null;

    /// <summary>The text of a keyword; empty if the label does not have it.</summary>
    public string Text(string name) => Find(name)?.Text ?? string.Empty;

    /// <summary>The number of a keyword; null if the label does not have it.</summary>
    /// <exception cref="BadInputException">It is not a number.</exception>
    public double? Number(string name) => Find(name) is { } value ? Parse(name, value.Text) : null;

    /// <summary>s: the time of a keyword, which is in milliseconds if it has no unit; null if the label does not have it.</summary>
    /// <exception cref="BadInputException">It is not a time.</exception>
    public double? Seconds(string name) => Find(name) is not { } value ? null
        : value.Unit?.ToUpperInvariant() switch
        {
            null or "" or "MS" or "MSEC" or "MILLISECOND" or "MILLISECONDS" => Parse(name, value.Text) / 1000.0,
            "S" or "SEC" or "SECOND" or "SECONDS" => Parse(name, value.Text),
            _ => throw new BadInputException($"{path}: {name} is in <{value.Unit}>; ms or s is needed."),
        };

    /// <summary>The numbers of a keyword of a cube's NaifKeywords; null if they are not there.</summary>
    /// <exception cref="BadInputException">They are not numbers.</exception>
    public double[]? NaifNumbers(string name) =>
        Naif.TryGetValue(name, out LabelValue? value) ? [.. value.Items.Select(item => Parse(name, item))] : null;

    private double Parse(string name, string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? number
            : throw new BadInputException($"{path}: {name} is '{text}'; a number is needed.");
}

/// <summary>A value of a label.</summary>
/// <param name="Items">Its texts; several for a sequence.</param>
/// <param name="Unit">Unit as the label writes it; null for none.</param>
public sealed record LabelValue(IReadOnlyList<string> Items, string? Unit = null)
{
    /// <summary>The first text; empty for an empty sequence.</summary>
    public string Text => Items.Count > 0 ? Items[0] : string.Empty;
}
