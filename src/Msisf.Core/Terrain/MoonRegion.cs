namespace Msisf.Core.Terrain;

/// <summary>A part of the Moon with borders on whole degrees; <c>default</c> is empty and never handed out.</summary>
/// <param name="SouthDegrees">-90 to 89.</param>
/// <param name="NorthDegrees">Above the southern border, up to 90.</param>
/// <param name="WestDegrees">0 to 359.</param>
/// <param name="EastDegrees">
/// Above the western border, by 360 at most: of a region over the prime meridian it is above 360, e.g. 350 and 370.
/// </param>
public readonly record struct MoonRegion(int SouthDegrees, int NorthDegrees, int WestDegrees, int EastDegrees)
{
    /// <summary>How a region is written, for messages and help.</summary>
    public const string ValidValues =
        "latmin:latmax:lonmin:lonmax in whole degrees, -90 <= latmin < latmax <= 90, lonmin and lonmax from -180 to 360; "
        + "over the prime meridian lonmin is the larger one, as in 350:10, or negative, as in -10:10";

    /// <summary>The whole Moon.</summary>
    public static MoonRegion WholeMoon { get; } = new(-90, 90, 0, 360);

    /// <summary>Reads "latmin:latmax:lonmin:lonmax".</summary>
    /// <exception cref="UsageException">The text is not a region.</exception>
    public static MoonRegion Parse(string text)
    {
        string[] parts = text.Split(':');
        int[] borders = new int[4];
        for (int i = 0; i < 4; i++)
        {
            if (parts.Length != 4 || !int.TryParse(parts[i], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out borders[i]))
            {
                throw Wrong(text);
            }
        }

        if (borders[2] is < -180 or > 360 || borders[3] is < -180 or > 360 || borders[2] == borders[3])
        {
            throw Wrong(text);
        }

        int width = borders[3] - borders[2] > 0 ? borders[3] - borders[2] : borders[3] - borders[2] + 360;
        int west = width == 360 ? 0 : (borders[2] + 360) % 360;
        MoonRegion region = new(borders[0], borders[1], west, west + width);
        return region.IsValid ? region : throw Wrong(text);
    }

    /// <summary>Whether the borders are in range and in order.</summary>
    public bool IsValid =>
        SouthDegrees >= -90 && SouthDegrees < NorthDegrees && NorthDegrees <= 90
        && WestDegrees is >= 0 and < 360 && WestDegrees < EastDegrees && EastDegrees <= WestDegrees + 360;

    /// <summary>Whether the prime meridian lies inside.</summary>
    public bool CrossesPrimeMeridian => EastDegrees > 360;

    /// <summary>Longitude of the eastern border, degrees, 1 to 360.</summary>
    public int EastLongitude => CrossesPrimeMeridian ? EastDegrees - 360 : EastDegrees;

    private static UsageException Wrong(string text) => new($"--region {text}: {ValidValues} is needed.");
}
