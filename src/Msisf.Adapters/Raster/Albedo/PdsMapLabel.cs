using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>What a PDS3 label, attached or detached, says of an equirectangular map.</summary>
/// <param name="ImagePath">The file of the samples.</param>
/// <param name="ImageOffset">Bytes before the first sample.</param>
/// <param name="Lines">Pixels from north to south.</param>
/// <param name="LineSamples">Pixels from west to east.</param>
/// <param name="SampleType">SAMPLE_TYPE with SAMPLE_BITS: whole numbers of 8 or 16 bits, or real ones of 32.</param>
/// <param name="ScalingFactor">A step of the stored value.</param>
/// <param name="Offset">The stored value 0.</param>
/// <param name="MissingConstant">The value of samples without data; null if the label has none.</param>
/// <param name="Unit">UNIT of the values; empty if the label has none.</param>
/// <param name="PixelsPerDegree">MAP_RESOLUTION.</param>
/// <param name="WestDegrees">East longitude of the left edge, degrees.</param>
/// <param name="NorthDegrees">Latitude of the upper edge, degrees.</param>
internal sealed record PdsMapLabel(
    PdsMapHead Head, string ImagePath, long ImageOffset, int Lines, int LineSamples, PdsSampleType SampleType,
    double ScalingFactor, double Offset, double? MissingConstant, string Unit, double PixelsPerDegree, double WestDegrees,
    double NorthDegrees)
{
    public string LabelPath => Head.LabelPath;

    /// <summary>What the map shows.</summary>
    public MapExtent Extent => new(
        double.DegreesToRadians(WestDegrees),
        double.DegreesToRadians(NorthDegrees),
        double.DegreesToRadians(LineSamples / PixelsPerDegree),
        double.DegreesToRadians(Lines / PixelsPerDegree));

    /// <summary>Reads the label of a map; null if neither the file nor the .LBL beside it is a PDS3 label.</summary>
    /// <param name="path">The label, or the image.</param>
    /// <exception cref="BadInputException">A PDS3 label of something else than an equirectangular map.</exception>
    public static PdsMapLabel? TryRead(string path) => PdsMapHead.TryRead(path) is { } head ? Read(head) : null;

    /// <summary>Reads the label of a map.</summary>
    /// <exception cref="BadInputException">A PDS3 label of something else than an equirectangular map.</exception>
    public static PdsMapLabel Read(PdsMapHead head)
    {
        PdsObject projection = ProjectionOf(head);
        CheckProjection(projection);
        double perDegree = projection.RequiredNumber("MAP_RESOLUTION", PdsUnit.PixelsPerDegree);
        double west = projection.RequiredNumber("WESTERNMOST_LONGITUDE", PdsUnit.Degree);
        double north = projection.RequiredNumber("MAXIMUM_LATITUDE", PdsUnit.Degree);
        PdsMapLabel map = ReadImage(head) with { PixelsPerDegree = perDegree, WestDegrees = west, NorthDegrees = north };
        double slack = 1.0 / perDegree;
        return perDegree > 0.0 && map.LineSamples / perDegree <= 360.0 + slack && map.Lines / perDegree <= 180.0 + slack
            && north <= 90.0 + slack
                ? map
                : throw projection.WrongValue("MAP_RESOLUTION", "lines and samples of this size don't fit on the Moon");
    }

    /// <summary>Reads the label of a polar stereographic map: all but where it lies, which is left at 0.</summary>
    /// <exception cref="BadInputException">A PDS3 label of something else than a polar map.</exception>
    public static PdsMapLabel ReadPolar(PdsMapHead head) => head.IsPolar
        ? ReadImage(head)
        : throw ProjectionOf(head).WrongValue("MAP_PROJECTION_TYPE", "a polar stereographic map is needed");

    private static PdsObject ProjectionOf(PdsMapHead head) =>
        head.Label.FindObject("IMAGE_MAP_PROJECTION") ?? throw Missing(head.LabelPath, "IMAGE_MAP_PROJECTION");

    private static PdsMapLabel ReadImage(PdsMapHead head)
    {
        (string labelPath, PdsObject label) = head;
        PdsObject image = label.FindObject("IMAGE") ?? throw Missing(labelPath, "IMAGE");
        PdsImagePointer pointer = PdsImagePointer.Read(label, label.OptionalInteger("RECORD_BYTES", 1, int.MaxValue));
        string imagePath = pointer.PathBeside(labelPath);
        if (PdsSampleType.Of(image) is not
            { Type: PixelType.Unsigned8 or PixelType.Signed16 or PixelType.Unsigned16 or PixelType.Real32 } type)
        {
            throw image.WrongValue("SAMPLE_TYPE", $"with SAMPLE_BITS = {image.Required("SAMPLE_BITS")} it is not read; "
                + "whole numbers of 8 or 16 bits, or IEEE reals of 32, are needed");
        }

        int samples = image.RequiredInteger("LINE_SAMPLES", 1, int.MaxValue);
        int lines = image.RequiredInteger("LINES", 1, int.MaxValue);
        return new PdsMapLabel(
            Head: head,
            ImagePath: FileNames.FindIgnoringCase(imagePath)
                ?? throw new BadInputException(
                    $"{imagePath}: missing; {labelPath} says that the map is there. Put the file beside its label."),
            ImageOffset: pointer.Offset,
            Lines: lines,
            LineSamples: samples,
            SampleType: type,
            ScalingFactor: image.OptionalNumber("SCALING_FACTOR") ?? 1.0,
            Offset: image.OptionalNumber("OFFSET") ?? 0.0,
            MissingConstant: image.Find("MISSING_CONSTANT") is { Items: null } value ? type.Constant(value.Text) : null,
            Unit: image.Find("UNIT")?.Text ?? string.Empty,
            PixelsPerDegree: 0.0,
            WestDegrees: 0.0,
            NorthDegrees: 0.0);
    }

    private static void CheckProjection(PdsObject projection)
    {
        if (!PdsMapHead.IsOfLatitude(projection))
        {
            throw projection.WrongValue("MAP_PROJECTION_TYPE", "an equirectangular map with the equator as centre is needed");
        }

        PdsLongitudes.RequireEast(projection);
    }

    private static BadInputException Missing(string path, string what) =>
        new($"{path}: a PDS3 label without {what}. Give the label of an equirectangular map.");
}

/// <summary>A PDS3 label, attached or detached, with what tells whose map it is; the rest is not looked at yet.</summary>
/// <param name="LabelPath">The file of the label.</param>
internal sealed partial record PdsMapHead(string LabelPath, PdsObject Label)
{
    private const int LongestLabel = 65536;

    /// <summary>Name of the product, e.g. "WAC_EMP_643NM_E300N0450_064P"; empty if the label has none.</summary>
    public string Product => Label.Find("PRODUCT_ID")?.Text ?? string.Empty;

    /// <summary>
    /// The name that the tiles of one map have in common: LROC's archive puts projection and centre into a tile's name, which are left out
    /// here, e.g. "WAC_EMP_643NM_304P" of "WAC_EMP_643NM_E300N0450_304P" for 30.0 N 45.0 E.
    /// </summary>
    public string Map => MapOf(Product);

    /// <summary>The band in the product's name, nm; null if it has none.</summary>
    public int? BandNanometres => BandInName().Match(Product) is { Success: true } match
        ? int.Parse(match.Groups[1].ValueSpan, CultureInfo.InvariantCulture)
        : null;

    /// <summary>Whether the map shows the surroundings of a pole.</summary>
    public bool IsPolar => Label.FindObject("IMAGE_MAP_PROJECTION")?.Find("MAP_PROJECTION_TYPE")?.Text
        .Contains("POLAR", StringComparison.OrdinalIgnoreCase) == true;

    /// <summary>Whether the map's rows are not parallels a part of a degree apart: GDAL reads such maps.</summary>
    public bool IsForGdal => Label.FindObject("IMAGE_MAP_PROJECTION") is { } projection && !IsOfLatitude(projection);

    /// <summary>The file of the samples.</summary>
    public string ImagePath => PdsImagePointer.Read(Label, Label.OptionalInteger("RECORD_BYTES", 1, int.MaxValue)).PathBeside(LabelPath);

    /// <summary>Incidence, emission and phase angle of the image, degrees; null if the label does not say them.</summary>
    public (double Incidence, double Emission, double Phase)? Angles =>
        (AngleOf("INCIDENCE_ANGLE"), AngleOf("EMISSION_ANGLE"), AngleOf("PHASE_ANGLE")) is (double i, double e, double g)
            ? (i, e, g)
            : null;

    /// <summary>Whether a map is equirectangular with the equator as centre.</summary>
    public static bool IsOfLatitude(PdsObject projection) =>
        PdsValue.WordOf(projection.RequiredText("MAP_PROJECTION_TYPE")) is var kind
        && (kind == "SIMPLE_CYLINDRICAL"
            || (kind == "EQUIRECTANGULAR" && (projection.OptionalNumber("CENTER_LATITUDE", PdsUnit.Degree) ?? 0.0) == 0.0));

    /// <summary>Whether a product's name has a centre; if not, its map is in one file.</summary>
    public static bool IsTile(string product) => Centre().IsMatch(product);

    /// <summary>The name of the map of a product.</summary>
    public static string MapOf(string product) => Centre().Replace(product, string.Empty, count: 1).ToUpperInvariant();

    /// <summary>Reads the label of a file; null if neither the file nor the .LBL beside it is a PDS3 label.</summary>
    /// <param name="path">The label, or the image.</param>
    /// <exception cref="BadInputException">The file can't be read, or the label is damaged.</exception>
    public static PdsMapHead? TryRead(string path)
    {
        string labelPath = FileNames.LabelOf(path);
        string text = FileErrors.ToBadInput($"{labelPath}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(labelPath);
            return PdsLabelParser.TextOf(stream, LongestLabel);
        });
        return PdsLabelParser.IsLabel(text)
            ? new PdsMapHead(labelPath, PdsLabelParser.Parse(text, labelPath))
            : null;
    }

    /// <summary>Reads the label of a map among other files; null if the file is none, or its label is damaged.</summary>
    /// <param name="path">The label, or the image.</param>
    public static PdsMapHead? TryReadMap(string path)
    {
        try
        {
            return TryRead(path) is { } head && head.Label.FindObject("IMAGE_MAP_PROJECTION") is not null ? head : null;
        }
        catch (BadInputException)
        {
            return null;
        }
    }

    private double? AngleOf(string name) => Label.OptionalNumber(name, PdsUnit.Degree);

    [GeneratedRegex(@"_(\d{3})NM")]
    private static partial Regex BandInName();

    [GeneratedRegex("_[A-Z][0-9]{3}[NS][0-9]{4}(?=[_.]|$)", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Centre();
}
