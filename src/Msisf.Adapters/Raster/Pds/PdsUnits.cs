namespace Msisf.Adapters.Raster.Pds;

/// <summary>The spellings of units that labels use; the first is NASA's in LDEM labels.</summary>
internal static class PdsUnits
{
    /// <summary>Angles.</summary>
    public static readonly string[] Degrees = ["deg", "degree", "degrees"];

    /// <summary>Resolutions.</summary>
    public static readonly string[] PixelsPerDegree = ["pix/deg", "pixel/deg", "pixel/degree", "pixels/degree"];

    /// <summary>Places in an image.</summary>
    public static readonly string[] Pixels = ["pix", "pixel", "pixels"];

    /// <summary>Map scales.</summary>
    public static readonly string[] MetresPerPixel = ["m/pix", "m/pixel", "meter/pix", "meter/pixel", "meters/pix", "meters/pixel"];

    /// <summary>Map scales in km.</summary>
    public static readonly string[] KilometresPerPixel =
        ["km/pix", "km/pixel", "kilometer/pix", "kilometer/pixel", "kilometers/pix", "kilometers/pixel"];

    /// <summary>Lengths.</summary>
    public static readonly string[] Kilometres = ["km", "kilometer", "kilometers"];
}
