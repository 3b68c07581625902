namespace Msisf.Adapters.Raster.Pds;

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
