using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.Raster.Albedo;

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

    /// <summary>Whether it is a map whose rows are no parallels a degree's part apart: GDAL reads these.</summary>
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
        projection.RequiredText("MAP_PROJECTION_TYPE").Replace('_', ' ').ToUpperInvariant() is var kind
        && (kind == "SIMPLE CYLINDRICAL"
            || (kind == "EQUIRECTANGULAR" && (projection.OptionalNumber("CENTER_LATITUDE", "DEG", "DEGREE") ?? 0.0) == 0.0));

    /// <summary>Whether a product's name has a centre; if not, its map is in one file.</summary>
    public static bool IsTile(string product) => Centre().IsMatch(product);

    /// <summary>The name of the map of a product.</summary>
    public static string MapOf(string product) => Centre().Replace(product, string.Empty, count: 1).ToUpperInvariant();

    /// <summary>Reads the label of a file; null if the file and the .LBL beside it are no PDS3 labels.</summary>
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
        return text.StartsWith("PDS_VERSION_ID", StringComparison.Ordinal)
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

    private double? AngleOf(string name) => Label.OptionalNumber(name, "DEG", "DEGREE", "DEGREES");

    [GeneratedRegex(@"_(\d{3})NM")]
    private static partial Regex BandInName();

    [GeneratedRegex("_[A-Z][0-9]{3}[NS][0-9]{4}(?=[_.]|$)", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Centre();
}
