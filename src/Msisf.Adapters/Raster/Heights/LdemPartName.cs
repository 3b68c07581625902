using System.Text.RegularExpressions;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The name of a part of a split product: the archive puts the part's borders into it, e.g. "LDEM_512_00N_45N_000_090_FLOAT".
/// </summary>
/// <param name="Before">What stands before the borders, e.g. "LDEM_512"; the whole name if it has none.</param>
/// <param name="After">What stands behind them, e.g. "_FLOAT".</param>
internal sealed partial record LdemPartName(string Before, string After, bool HasBorders)
{
    /// <summary>The name without borders: what the parts of one model have in common.</summary>
    public string Model => Before + After;

    /// <summary>Takes a label's PRODUCT_ID apart.</summary>
    public static LdemPartName Of(LdemLabel label)
    {
        Match borders = Borders().Match(label.ProductId);
        return borders.Success
            ? new LdemPartName(label.ProductId[..borders.Index], label.ProductId[(borders.Index + borders.Length)..], HasBorders: true)
            : new LdemPartName(label.ProductId, string.Empty, HasBorders: false);
    }

    /// <summary>The name of another part of the same model.</summary>
    public string ForRegion(MoonRegion region) => HasBorders
        ? $"{Before}_{BordersOf(region)}{After}"
        : string.Create(
            CultureInfo.InvariantCulture,
            $"latitudes {region.SouthDegrees} to {region.NorthDegrees}, longitudes {region.WestDegrees} to {region.EastDegrees}");

    /// <summary>Borders as the archive writes them: "00N_45N_000_090".</summary>
    public static string BordersOf(MoonRegion region) => string.Create(
        CultureInfo.InvariantCulture,
        $"{Latitude(region.SouthDegrees, region)}_{Latitude(region.NorthDegrees, region)}_"
            + $"{region.WestDegrees:000}_{region.EastLongitude:000}");

    // The equator is 00N, except as the northern border of a southern region.
    private static string Latitude(int degrees, MoonRegion region)
    {
        bool south = degrees < 0 || (degrees == 0 && region.NorthDegrees == 0);
        return string.Create(CultureInfo.InvariantCulture, $"{Math.Abs(degrees):00}{(south ? 'S' : 'N')}");
    }

    [GeneratedRegex("_[0-9]{1,2}[NS]_[0-9]{1,2}[NS]_[0-9]{1,3}_[0-9]{1,3}", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Borders();
}
