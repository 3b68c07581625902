namespace Msisf.Adapters.Raster.Pds;

/// <summary>The units of labels, each in the spelling that stands for all others.</summary>
internal static class PdsUnit
{
    public const string Degree = "deg";
    public const string PixelsPerDegree = "pix/deg";
    public const string Pixel = "pix";
    public const string MetresPerPixel = "m/pix";
    public const string KilometresPerPixel = "km/pix";
    public const string Metre = "m";
    public const string Kilometre = "km";

    private static readonly Dictionary<string, string[]> Spellings = new(StringComparer.Ordinal)
    {
        [Degree] = ["degree", "degrees"],
        [Pixel] = ["pixel", "pixels", "px"],
        [Metre] = ["meter", "meters", "metre", "metres"],
        [Kilometre] = ["kilometer", "kilometers", "kilometre", "kilometres"],
    };

    /// <summary>
    /// A unit as labels write it, e.g. "PIXELS/DEGREE", in the spelling of the constants; an unknown one in small letters.
    /// </summary>
    public static string Of(string text) => string.Join('/', text.ToLowerInvariant().Split('/', StringSplitOptions.TrimEntries)
        .Select(part => Spellings.FirstOrDefault(unit => unit.Value.Contains(part)).Key ?? part));
}
