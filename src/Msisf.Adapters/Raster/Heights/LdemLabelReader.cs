using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Reads the PDS3 label of a lunar elevation model (LDEM) in simple cylindrical or polar stereographic projection, and checks it against
/// itself.
/// </summary>
public static class LdemLabelReader
{
    /// <summary>Bytes. A label has a few kilobytes; of a file with an attached label no more than this is read.</summary>
    private const int LabelLimit = 1 << 20;

    /// <summary>What DATA_SET_ID or PRODUCT_ID of LOLA's products and of synthetic ones have.</summary>
    private static readonly string[] OwnNames = ["LOLA", "LDEM", LdemLabel.SyntheticMark];

    /// <summary>PDS3's names of a sample value without data.</summary>
    private static readonly string[] MissingKeywords =
        ["MISSING_CONSTANT", "INVALID_CONSTANT", "UNKNOWN_CONSTANT", "NOT_APPLICABLE_CONSTANT"];

    /// <summary>180 degrees at 23 000 px/deg, far more than any product has.</summary>
    private const int LineLimit = 1 << 22;

    /// <summary>Reads a label's file.</summary>
    /// <param name="labelPath">The .LBL file, or an image with its label attached.</param>
    /// <exception cref="BadInputException">
    /// The label is missing, unreadable, incomplete, contradicts itself, or describes no lunar elevation model.
    /// </exception>
    public static LdemLabel ReadFile(string labelPath) => FileErrors.ToBadInput($"{labelPath}: can't be read", () =>
    {
        if (!File.Exists(labelPath))
        {
            throw new BadInputException($"{labelPath}: there is no such file or folder. Name an elevation model's label or its folder.");
        }

        if (BareImage.LabelOf(labelPath) is { } ofImage)
        {
            return ofImage;
        }

        using FileStream stream = File.OpenRead(labelPath);
        return Read(stream, labelPath);
    });

    /// <summary>Whether what is wrong in a label is to be told: one of LOLA's products, of a synthetic one, or of another body.</summary>
    /// <param name="labelPath">A label that can't be read as that of an elevation model.</param>
    internal static bool IsOfReader(string labelPath)
    {
        try
        {
            using FileStream stream = File.OpenRead(labelPath);
            PdsObject root = PdsLabelParser.Parse(PdsLabelParser.TextOf(stream, LabelLimit), labelPath);
            string names = $"{root.Find("DATA_SET_ID")} {root.Find("PRODUCT_ID")}".ToUpperInvariant();
            return Array.Exists(OwnNames, name => names.Contains(name, StringComparison.Ordinal))
                || !(root.Find("TARGET_NAME") is { } target && CelestialBody.Find(target.ToString()) is { IsMoon: true });
        }
        catch (Exception exception) when (exception is BadInputException || exception.IsFileError())
        {
            return true;
        }
    }

    /// <summary>Reads a label.</summary>
    /// <param name="stream">Begins with the label.</param>
    /// <param name="labelPath">Path for messages, and to find the image beside it.</param>
    /// <exception cref="BadInputException">As <see cref="ReadFile"/>.</exception>
    public static LdemLabel Read(Stream stream, string labelPath)
    {
        PdsObject root = PdsLabelParser.Parse(PdsLabelParser.TextOf(stream, LabelLimit), labelPath);
        PdsObject map = root.FindObject("IMAGE_MAP_PROJECTION") ?? throw Missing(labelPath, "IMAGE_MAP_PROJECTION");
        LdemLabelChecks.CheckKind(root, map);
        PdsObject image = root.FindObject("IMAGE") ?? throw Missing(labelPath, "IMAGE");
        PdsObject file = FileHolder(root);
        int? recordBytes = file.OptionalInteger("RECORD_BYTES", 1, int.MaxValue);
        PdsImagePointer pointer = PdsImagePointer.Read(file, recordBytes);
        (string unit, double metresPerUnit) = UnitOf(image);
        LdemLabel label = new(
            LabelPath: labelPath,
            ImagePath: pointer.PathBeside(labelPath),
            ImageOffset: pointer.Offset,
            FileBytes: (long?)recordBytes * file.OptionalInteger("FILE_RECORDS", 1, int.MaxValue),
            ProductId: ProductIdOf(root),
            Body: LdemLabelChecks.BodyOf(root),
            PixelsPerDegree: LdemLabelChecks.IsPolar(map) ? 0 : ResolutionOf(map),
            Polar: LdemLabelChecks.IsPolar(map) ? PolarLabel.ProjectionOf(map) : null,
            Lines: image.RequiredInteger("LINES", 1, LineLimit),
            LineSamples: image.RequiredInteger("LINE_SAMPLES", 1, 2 * LineLimit),
            SampleType: SampleTypeOf(image),
            ScalingFactor: metresPerUnit * image.RequiredNumber("SCALING_FACTOR", unit),
            Offset: metresPerUnit * image.RequiredNumber("OFFSET", unit),
            Minimum: image.OptionalNumber("MINIMUM") ?? double.NegativeInfinity,
            Maximum: image.OptionalNumber("MAXIMUM") ?? double.PositiveInfinity,
            NorthDegrees: map.RequiredNumber("MAXIMUM_LATITUDE", PdsUnit.Degree),
            SouthDegrees: map.RequiredNumber("MINIMUM_LATITUDE", PdsUnit.Degree),
            WestDegrees: map.RequiredNumber("WESTERNMOST_LONGITUDE", PdsUnit.Degree),
            EastDegrees: map.RequiredNumber("EASTERNMOST_LONGITUDE", PdsUnit.Degree),
            CoordinateSystem: map.Find("COORDINATE_SYSTEM_NAME")?.ToString() ?? string.Empty);
        if (label.Polar is null)
        {
            LdemLabelChecks.CheckCover(label, image, map);
            label = label.FromPrimeMeridian();
        }
        else
        {
            PolarLabel.CheckCover(label, image, map);
        }

        LdemLabelChecks.CheckSamples(label, image);
        label = WithinPlausible(label, MissingOf(image));
        LdemLabelChecks.CheckRadii(label, image, map);
        LdemLabelChecks.CheckRecords(label, file, isDetached: pointer.FileName is not null);
        return label;
    }

    /// <summary>
    /// The same label, whose limits leave out what can't be a height. Invented ground may go beyond: its limits are those of its samples.
    /// </summary>
    private static LdemLabel WithinPlausible(LdemLabel label, (string Keyword, double Value)? missing)
    {
        (double least, double greatest) = label.IsSynthetic && double.IsFinite(label.Minimum) && double.IsFinite(label.Maximum)
            ? (label.Minimum, label.Maximum)
            : (LimitOf(label, label.Body.PlausibleHeights.Min), LimitOf(label, label.Body.PlausibleHeights.Max));
        LdemLabel limited = label with
        {
            Minimum = Math.Max(label.Minimum, least),
            Maximum = Math.Min(label.Maximum, greatest),
            MayHaveGaps = label.Minimum < least || label.Maximum > greatest || missing is not null,
            Missing = missing?.Value,
        };
        return missing is ({ } keyword, var value) && value >= limited.Minimum && value <= limited.Maximum
            ? throw new BadInputException(Invariant(
                $"{label.LabelPath}: {keyword} = {value:R} is a height that can be. Convert the file: gdal_translate -a_scale "
                    + $"{label.ScalingFactor:R} -a_offset 0 {label.LabelPath} NEW.tif, and give that."))
            : limited;
    }

    /// <summary>The sample value of a plausible height.</summary>
    private static double LimitOf(LdemLabel label, double height)
    {
        double limit = (label.ReferenceRadius + height - label.Offset) / label.ScalingFactor;
        return label.HasIntegers ? Math.Clamp(limit, short.MinValue, short.MaxValue) : limit;
    }

    /// <summary>The value that an image declares as no data.</summary>
    private static (string Keyword, double Value)? MissingOf(PdsObject image)
    {
        foreach (string keyword in MissingKeywords)
        {
            if (image.Find(keyword) is { Items: null } value && PdsSampleType.Of(image)?.Constant(value.Text) is { } number)
            {
                return (keyword, number);
            }
        }

        return null;
    }

    /// <summary>The object that describes the image's file. Labels of products that exist as .JP2, too, have one for each file.</summary>
    private static PdsObject FileHolder(PdsObject root) =>
        new[] { root.FindObject("UNCOMPRESSED_FILE"), root.FindObject("FILE") }
            .FirstOrDefault(candidate => candidate?.Find("^IMAGE") is not null) ?? root;

    private static (string Unit, double Metres) UnitOf(PdsObject image) => PdsUnit.Of(image.RequiredText("UNIT")) switch
    {
        PdsUnit.Metre => (PdsUnit.Metre, 1.0),
        PdsUnit.Kilometre => (PdsUnit.Kilometre, 1000.0),
        _ => throw image.WrongValue("UNIT", "METER or KILOMETER is needed"),
    };

    private static LdemSampleType SampleTypeOf(PdsObject image) => PdsSampleType.Of(image) switch
    {
        (PixelType.Signed16, false) => LdemSampleType.Int16LittleEndian,
        (PixelType.Signed16, true) => LdemSampleType.Int16BigEndian,
        (PixelType.Real32, false) => LdemSampleType.Float32LittleEndian,
        (PixelType.Real32, true) => LdemSampleType.Float32BigEndian,
        _ => throw image.WrongValue(
            "SAMPLE_TYPE",
            $"with SAMPLE_BITS = {image.Required("SAMPLE_BITS")} it is not known; "
                + $"16-bit LSB_INTEGER or MSB_INTEGER, or 32-bit PC_REAL or IEEE_REAL are needed"),
    };

    private static int ResolutionOf(PdsObject map)
    {
        map.RequiredNumber("MAP_RESOLUTION", PdsUnit.PixelsPerDegree);
        return map.RequiredInteger("MAP_RESOLUTION", 1, LineLimit / 180);
    }

    private static string ProductIdOf(PdsObject root)
    {
        string text = root.RequiredText("PRODUCT_ID");
        return text.Length <= 40 && text.All(character => char.IsAsciiLetterOrDigit(character) || character is '_' or '-' or '.')
            ? text
            : throw root.WrongValue("PRODUCT_ID", "1 to 40 letters, digits, '_', '-' or '.' are needed");
    }

    private static BadInputException Missing(string labelPath, string name) =>
        new($"{labelPath}: no OBJECT = {name}. Give the label of a LDEM product.");
}
