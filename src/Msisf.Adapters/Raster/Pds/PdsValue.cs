namespace Msisf.Adapters.Raster.Pds;

/// <summary>A value of a PDS3 label: one text, or a sequence or set of values.</summary>
/// <param name="Text">The text without quotes; empty for a sequence or set.</param>
/// <param name="IsQuoted">The text stood in quotes, so it is no number.</param>
/// <param name="Unit">Unit as written, e.g. "pix/deg"; null if none is given.</param>
/// <param name="Items">The values of a sequence or set; null for one text.</param>
/// <param name="Line">Line of the label, from 1.</param>
public sealed record PdsValue(string Text, bool IsQuoted, string? Unit, IReadOnlyList<PdsValue>? Items, int Line)
{
    /// <summary>As the label writes it, on one line.</summary>
    public override string ToString() => Items is null
        ? string.Join(' ', Text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)) + (Unit is null ? string.Empty : $" <{Unit}>")
        : $"({string.Join(", ", Items)})";
}
