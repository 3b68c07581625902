using System.Globalization;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>What a PDS3 label, attached or detached, says of an equirectangular map.</summary>
internal sealed record PdsMapLabel
{
    public required string LabelPath { get; init; }

    public required string ImagePath { get; init; }

    /// <summary>Name of the product, e.g. "WAC_EMP_643NM_E300N0450_064P"; empty if the label has none.</summary>
    public required string Product { get; init; }

    /// <summary>Bytes before the first sample.</summary>
    public required long ImageOffset { get; init; }

    public required int Lines { get; init; }

    public required int LineSamples { get; init; }

    /// <summary>SAMPLE_TYPE, e.g. "PC_REAL".</summary>
    public required string SampleType { get; init; }

    /// <summary>8 or 16 for whole numbers, 32 for real ones.</summary>
    public required int SampleBits { get; init; }

    public required bool IsSigned { get; init; }

    public required bool IsMostSignificantFirst { get; init; }

    public required double ScalingFactor { get; init; }

    public required double Offset { get; init; }

    /// <summary>The value of samples without data; null if the label has none.</summary>
    public required double? MissingConstant { get; init; }

    /// <summary>UNIT of the values; empty if the label has none.</summary>
    public required string Unit { get; init; }

    public required double PixelsPerDegree { get; init; }

    /// <summary>East longitude of the left edge, degrees.</summary>
    public required double WestDegrees { get; init; }

    /// <summary>Latitude of the upper edge, degrees.</summary>
    public required double NorthDegrees { get; init; }

    /// <summary>What the map shows.</summary>
    public MapExtent Extent => new(
        double.DegreesToRadians(WestDegrees),
        double.DegreesToRadians(NorthDegrees),
        double.DegreesToRadians(LineSamples / PixelsPerDegree),
        double.DegreesToRadians(Lines / PixelsPerDegree));

    /// <summary>The band in the product's name, nm; null if it has none.</summary>
    public required int? BandNanometres { get; init; }

    /// <summary>Reads the label of a map; null if the file and the .LBL beside it are no PDS3 labels.</summary>
    /// <param name="path">The label, or the image.</param>
    /// <exception cref="BadInputException">A PDS3 label of something else than an equirectangular map.</exception>
    public static PdsMapLabel? TryRead(string path) => PdsMapHead.TryRead(path) is { } head ? Read(head) : null;

    /// <summary>Reads the label of a map.</summary>
    /// <exception cref="BadInputException">A PDS3 label of something else than an equirectangular map.</exception>
    public static PdsMapLabel Read(PdsMapHead head)
    {
        (string labelPath, PdsObject label) = head;
        PdsObject image = label.FindObject("IMAGE") ?? throw Missing(labelPath, "IMAGE");
        PdsObject projection = label.FindObject("IMAGE_MAP_PROJECTION") ?? throw Missing(labelPath, "IMAGE_MAP_PROJECTION");
        PdsImagePointer pointer = PdsImagePointer.Read(label, label.OptionalInteger("RECORD_BYTES", 1, int.MaxValue));
        string imagePath = pointer.FileName is null
            ? labelPath
            : Path.Combine(Path.GetDirectoryName(labelPath) ?? string.Empty, pointer.FileName);
        string type = image.RequiredText("SAMPLE_TYPE");
        int bits = image.RequiredInteger("SAMPLE_BITS", 8, 32);
        bool isReal = type.EndsWith("REAL", StringComparison.Ordinal);
        if (isReal ? bits != 32 : bits is not (8 or 16))
        {
            throw image.WrongValue(
                "SAMPLE_BITS", image.Required("SAMPLE_BITS"), "whole numbers of 8 or 16 bits, or real ones of 32, are read");
        }

        (double perDegree, double west, double north) = PlaceOf(image, projection);
        return new PdsMapLabel
        {
            LabelPath = labelPath,
            ImagePath = FileNames.FindIgnoringCase(imagePath)
                ?? throw new BadInputException(
                    $"{imagePath}: missing; {labelPath} says that the map is there. Put the file beside its label."),
            Product = head.Product,
            BandNanometres = head.BandNanometres,
            ImageOffset = pointer.Offset,
            Lines = image.RequiredInteger("LINES", 1, int.MaxValue),
            LineSamples = image.RequiredInteger("LINE_SAMPLES", 1, int.MaxValue),
            SampleType = type,
            SampleBits = bits,
            IsSigned = !type.Contains("UNSIGNED", StringComparison.Ordinal),
            IsMostSignificantFirst = !(type.StartsWith("LSB", StringComparison.Ordinal) || type.StartsWith("PC", StringComparison.Ordinal)
                || type.StartsWith("VAX", StringComparison.Ordinal)),
            ScalingFactor = image.OptionalNumber("SCALING_FACTOR") ?? 1.0,
            Offset = image.OptionalNumber("OFFSET") ?? 0.0,
            MissingConstant = Constant(image, "MISSING_CONSTANT"),
            Unit = image.Find("UNIT")?.Text ?? string.Empty,
            PixelsPerDegree = perDegree,
            WestDegrees = west,
            NorthDegrees = north,
        };
    }

    /// <summary>The resolution, the western and the northern edge.</summary>
    private static (double PerDegree, double West, double North) PlaceOf(PdsObject image, PdsObject projection)
    {
        string kind = projection.RequiredText("MAP_PROJECTION_TYPE").Replace('_', ' ').ToUpperInvariant();
        if (kind is not ("EQUIRECTANGULAR" or "SIMPLE CYLINDRICAL")
            || (kind == "EQUIRECTANGULAR" && (projection.OptionalNumber("CENTER_LATITUDE", "DEG", "DEGREE") ?? 0.0) != 0.0))
        {
            throw projection.WrongValue(
                "MAP_PROJECTION_TYPE", projection.Required("MAP_PROJECTION_TYPE"),
                "an equirectangular map with the equator as centre is needed");
        }

        double perDegree = projection.RequiredNumber("MAP_RESOLUTION", "PIX/DEG", "PIXEL/DEG", "PIXEL/DEGREE", "PIXELS/DEGREE");
        double width = image.RequiredInteger("LINE_SAMPLES", 1, int.MaxValue) / perDegree;
        double height = image.RequiredInteger("LINES", 1, int.MaxValue) / perDegree;
        double west = projection.RequiredNumber("WESTERNMOST_LONGITUDE", "DEG", "DEGREE");
        double north = projection.RequiredNumber("MAXIMUM_LATITUDE", "DEG", "DEGREE");
        double slack = 1.0 / perDegree;
        if (!(perDegree > 0.0) || width > 360.0 + slack || height > 180.0 + slack || north > 90.0 + slack)
        {
            throw projection.WrongValue(
                "MAP_RESOLUTION", projection.Required("MAP_RESOLUTION"), "lines and samples of this size don't fit on the Moon");
        }

        return (perDegree, west, north);
    }

    /// <summary>A number of the label; null if it is missing or written as bits, as the special values of real numbers are.</summary>
    private static double? Constant(PdsObject image, string keyword) => image.Find(keyword) is { IsQuoted: false, Items: null } value
        && double.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
            ? number
            : null;

    private static BadInputException Missing(string path, string what) =>
        new($"{path}: a PDS3 label without {what}. Give the label of an equirectangular map.");
}
