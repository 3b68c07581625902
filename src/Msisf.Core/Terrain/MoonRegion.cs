using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Core.Terrain;

/// <summary>A part of the Moon with borders on whole degrees; <c>default</c> is empty and never handed out.</summary>
/// <param name="SouthDegrees">-90 to 89.</param>
/// <param name="NorthDegrees">Above the southern border, up to 90.</param>
/// <param name="WestDegrees">0 to 359.</param>
/// <param name="EastDegrees">Above the western border, up to 360.</param>
public readonly record struct MoonRegion(int SouthDegrees, int NorthDegrees, int WestDegrees, int EastDegrees)
{
    /// <summary>How a region is written, for messages and help.</summary>
    public const string ValidValues =
        "latmin:latmax:lonmin:lonmax in whole degrees, -90 <= latmin < latmax <= 90, 0 <= lonmin < lonmax <= 360";

    /// <summary>The whole Moon.</summary>
    public static MoonRegion WholeMoon { get; } = new(-90, 90, 0, 360);

    /// <summary>Reads "latmin:latmax:lonmin:lonmax".</summary>
    /// <exception cref="UsageException">The text is no region.</exception>
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

        MoonRegion region = new(borders[0], borders[1], borders[2], borders[3]);
        return region.IsValid ? region : throw Wrong(text);
    }

    /// <summary>Whether the borders are in range and in order.</summary>
    public bool IsValid =>
        SouthDegrees >= -90 && SouthDegrees < NorthDegrees && NorthDegrees <= 90
        && WestDegrees >= 0 && WestDegrees < EastDegrees && EastDegrees <= 360;

    private static UsageException Wrong(string text) => new($"--region {text}: {ValidValues} is needed.");
}
