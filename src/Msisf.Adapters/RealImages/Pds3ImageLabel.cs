using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>Reads the label of a PDS3 image.</summary>
/// <remarks>Planetary Data System Standards Reference 3.8, appendix A.19 (IMAGE).</remarks>
internal static class Pds3ImageLabel
{
    /// <summary>The machines of which a number's type is named, and whether they put the most significant byte first.</summary>
    private static readonly Dictionary<string, bool> Machines = new(StringComparer.Ordinal)
    {
        ["MSB_"] = true,
        ["MAC_"] = true,
        ["SUN_"] = true,
        ["IEEE_"] = true,
        ["LSB_"] = false,
        ["PC_"] = false,
        ["VAX_"] = false,
    };

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
        (PixelType type, bool isBigEndian) = TypeOf(image);
        (string file, long offset) = PointerOf(holder, image, path, label);
        PixelLayout layout = new(file, offset, type, isBigEndian, (bands, lines, samples), default)
        {
            Base = image.OptionalNumber("OFFSET") ?? 0.0,
            Multiplier = image.OptionalNumber("SCALING_FACTOR") ?? 1.0,
            IsMissing = MissingOf(image),
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

    private static (PixelType Type, bool IsBigEndian) TypeOf(PdsObject image)
    {
        string name = image.Required("SAMPLE_TYPE").Word;
        string machine = Machines.Keys.FirstOrDefault(key => name.StartsWith(key, StringComparison.Ordinal)) ?? string.Empty;
        bool isBigEndian = Machines.GetValueOrDefault(machine, true);
        string number = name[machine.Length..];
        bool isUnsigned = number == "UNSIGNED_INTEGER";
        PixelType type = (number, image.RequiredInteger("SAMPLE_BITS", 1, 64)) switch
        {
            // LROC's labels say LSB_INTEGER of 8 bits, which count from 0 to 255.
            ("INTEGER" or "UNSIGNED_INTEGER", 8) => PixelType.Unsigned8,
            ("INTEGER" or "UNSIGNED_INTEGER", 16) => isUnsigned ? PixelType.Unsigned16 : PixelType.Signed16,
            ("INTEGER", 32) => PixelType.Signed32,
            ("REAL" or "FLOAT", 32) when machine != "VAX_" => PixelType.Real32,
            ("REAL" or "FLOAT", 64) when machine != "VAX_" => PixelType.Real64,
            _ => throw image.WrongValue("SAMPLE_TYPE", "integers of 8, 16 or 32 bits and IEEE reals of 32 or 64 bits are read"),
        };
        return (type, isBigEndian);
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

    private static Func<double, bool> MissingOf(PdsObject image)
    {
        double[] values = [.. NoValue.Select(image.Find).OfType<PdsValue>().SelectMany(value => value.Items ?? [value])
            .Select(item => double.TryParse(item.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                ? number
                : double.NaN)];
        return number => values.Contains(number);
    }
}
