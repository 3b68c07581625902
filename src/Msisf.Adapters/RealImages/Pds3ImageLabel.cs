using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>Reads the label of a PDS3 image.</summary>
/// <remarks>Planetary Data System Standards Reference 3.8, appendix A.19 (IMAGE).</remarks>
internal static class Pds3ImageLabel
{
    private static readonly string[] NoValue =
        ["MISSING_CONSTANT", "MISSING", "INVALID_CONSTANT", "INVALID_VALUE", "NOT_APPLICABLE_CONSTANT", "NULL", "CORE_NULL"];

    /// <summary>Reads the label.</summary>
    /// <param name="text">Its text; what follows its END is not looked at.</param>
    /// <param name="path">Its file.</param>
    /// <exception cref="BadInputException">Something is missing or wrong.</exception>
    public static ImageLabel Read(string text, string path)
    {
        PdsObject label = PdsLabelParser.Parse(text, path);
        (PdsObject holder, PdsObject image) = ImageOf(label)
            ?? throw new BadInputException($"{path}: the label has no object IMAGE. Give the label of an image.");
        Dictionary<string, LabelValue> keywords = new(StringComparer.Ordinal);
        foreach ((string name, PdsValue value) in label.Values.Concat(image.Values))
        {
            keywords.TryAdd(ImageLabel.NameOf(name), ImageLabelReader.ValueOf(value));
        }

        return new ImageLabel(path, keywords)
        {
            Kind = "PDS3",
            Pixels = PixelsOf(holder, image, path, label),
            Contradictions = label.Contradictions.Concat(image.Contradictions).DistinctBy(pair => ImageLabel.NameOf(pair.Key))
                .ToDictionary(pair => ImageLabel.NameOf(pair.Key), pair => pair.Value, StringComparer.Ordinal),
        };
    }

    /// <summary>The first object IMAGE, and the one that has its pointer.</summary>
    private static (PdsObject Holder, PdsObject Image)? ImageOf(PdsObject label) => label.All
        .Where(image => image.Name == "IMAGE" || image.Name.EndsWith("_IMAGE", StringComparison.Ordinal))
        .Select(image => (label.All.FirstOrDefault(holder => holder.Find($"^{image.Name}") is not null), image))
        .Where(found => found.Item1 is not null)
        .Select(found => ((PdsObject, PdsObject)?)(found.Item1!, found.image)).FirstOrDefault();

    private static PixelLayout PixelsOf(PdsObject holder, PdsObject image, string path, PdsObject label)
    {
        const int most = ImageLabelReader.MostPixels;
        (int bands, int lines, int samples) = (
            image.OptionalInteger("BANDS", 1, most) ?? 1, image.RequiredInteger("LINES", 1, most),
            image.RequiredInteger("LINE_SAMPLES", 1, most));
        PdsSampleType type = PdsSampleType.Of(image) ?? throw image.WrongValue(
            "SAMPLE_TYPE", "integers of 8, 16 or 32 bits and IEEE reals of 32 or 64 bits are read");
        (string file, long offset) = PointerOf(holder, image, path, label);
        PixelLayout layout = new(file, offset, type.Type, type.IsBigEndian, (bands, lines, samples), default)
        {
            Base = image.OptionalNumber("OFFSET") ?? 0.0,
            Multiplier = image.OptionalNumber("SCALING_FACTOR") ?? 1.0,
            IsMissing = MissingOf(image, type),
        };
        long bytes = layout.Bytes;
        long around = (image.OptionalInteger("LINE_PREFIX_BYTES", 0, most) ?? 0)
            + (image.OptionalInteger("LINE_SUFFIX_BYTES", 0, most) ?? 0);
        long line = (samples * bytes) + around;
        string order = image.Find("BAND_STORAGE_TYPE")?.Word ?? "BAND_SEQUENTIAL";
        return layout with
        {
            Offset = offset + (image.OptionalInteger("LINE_PREFIX_BYTES", 0, most) ?? 0),
            Strides = order switch
            {
                _ when bands == 1 => (line * lines, line, (int)bytes),
                "BAND_SEQUENTIAL" or "BSQ" => (line * lines, line, (int)bytes),
                "LINE_INTERLEAVED" or "BIL" => (line, line * bands, (int)bytes),
                "SAMPLE_INTERLEAVED" or "BIP" => (bytes, (samples * bytes * bands) + around, (int)bytes * bands),
                _ => throw image.WrongValue(
                    "BAND_STORAGE_TYPE", "BAND_SEQUENTIAL, LINE_INTERLEAVED or SAMPLE_INTERLEAVED is needed"),
            },
        };
    }

    private static (string File, long Offset) PointerOf(PdsObject holder, PdsObject image, string path, PdsObject label)
    {
        string keyword = $"^{image.Name}";
        PdsValue pointer = holder.Required(keyword);
        PdsValue[] parts = [.. pointer.Items ?? [pointer]];
        bool hasFile = parts.Length > 0 && !IsPlace(parts[0]);
        PdsValue? place = parts.Length == (hasFile ? 2 : 1) && IsPlace(parts[^1]) ? parts[^1]
            : hasFile && parts.Length == 1 ? null
            : throw holder.WrongValue(keyword, "a file name, a place, or both are needed");
        string file = hasFile ? ImageLabelReader.Beside(path, parts[0].Text) : path;
        if (place is null)
        {
            return (file, 0);
        }

        long number = long.Parse(place.Text, CultureInfo.InvariantCulture) - 1;
        int recordBytes = holder.OptionalInteger("RECORD_BYTES", 1, int.MaxValue)
            ?? label.OptionalInteger("RECORD_BYTES", 1, int.MaxValue) ?? 1;
        return (file, number * (place.Unit is null ? recordBytes : 1));
    }

    private static bool IsPlace(PdsValue value) => !value.IsQuoted && uint.TryParse(value.Text, out uint number) && number > 0;

    private static Func<double, bool> MissingOf(PdsObject image, PdsSampleType type)
    {
        double[] values = [.. NoValue.Select(image.Find).OfType<PdsValue>().SelectMany(value => value.Items ?? [value])
            .Select(item => type.Constant(item.Text)).OfType<double>()];
        return number => values.Contains(number);
    }
}
