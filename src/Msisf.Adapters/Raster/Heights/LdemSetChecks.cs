using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Checks that labels make up one model: of the same kind, without overlap and without gap.</summary>
internal static class LdemSetChecks
{
    /// <summary>Stands for a square degree that no part covers.</summary>
    public const ushort Nothing = ushort.MaxValue;

    /// <summary>All parts mean the same by a sample value.</summary>
    /// <exception cref="BadInputException">Two differ.</exception>
    public static void CheckAlike(IReadOnlyList<LdemLabel> parts) =>
        PdsAgreement.Require(
            parts, label => label.LabelPath, "part", "model",
            ("MAP_RESOLUTION", label => label.PixelsPerDegree),
            ("SAMPLE_TYPE", label => label.SampleType),
            ("SCALING_FACTOR (in m)", label => label.ScalingFactor),
            ("OFFSET (in m)", label => label.Offset),
            ("TARGET_NAME", label => label.Body.CapitalName),
            ("COORDINATE_SYSTEM_NAME", label => label.CoordinateSystem));

    /// <summary>Index of the part for each square degree, row by row from the north.</summary>
    /// <param name="mayBePart">Whether one part may stand alone, and several may make up a band between two parallels.</param>
    /// <exception cref="BadInputException">Borders between degrees, two parts for one place, or none.</exception>
    public static ushort[] Cover(IReadOnlyList<LdemLabel> parts, bool mayBePart)
    {
        ushort[] cover = new ushort[180 * 360];
        Array.Fill(cover, Nothing);
        for (int index = 0; index < parts.Count; index++)
        {
            MoonRegion region = RegionOf(parts[index]);
            for (int row = 90 - region.NorthDegrees; row < 90 - region.SouthDegrees; row++)
            {
                for (int degree = region.WestDegrees; degree < region.EastDegrees; degree++)
                {
                    ref ushort part = ref cover[(row * 360) + (degree % 360)];
                    part = part == Nothing ? (ushort)index : throw new BadInputException(Invariant(
                        $"{parts[part].LabelPath} and {parts[index].LabelPath}: both cover latitude {89 - row} to {90 - row}, "
                            + $"longitude {degree % 360} to {(degree % 360) + 1}. Take one of them away."));
                }
            }
        }

        return cover.Contains(Nothing) && !(mayBePart && (parts.Count == 1 || IsBand(cover))) ? throw Incomplete(parts, cover) : cover;
    }

    /// <summary>Whether labels make up the whole Moon, or a band around it.</summary>
    public static bool AreComplete(IReadOnlyList<LdemLabel> parts)
    {
        ushort[] cover = new ushort[180 * 360];
        Array.Fill(cover, Nothing);
        foreach (MoonRegion region in parts.Select(RegionOf))
        {
            for (int row = 90 - region.NorthDegrees; row < 90 - region.SouthDegrees; row++)
            {
                for (int degree = region.WestDegrees; degree < region.EastDegrees; degree++)
                {
                    cover[(row * 360) + (degree % 360)] = 0;
                }
            }
        }

        return !cover.Contains(Nothing) || IsBand(cover);
    }

    /// <summary>Whether the rows that are there are whole and follow each other.</summary>
    private static bool IsBand(ushort[] cover)
    {
        int first = cover.AsSpan().IndexOfAnyExcept(Nothing);
        int last = cover.AsSpan().LastIndexOfAnyExcept(Nothing);
        return first % 360 == 0 && last % 360 == 359 && !cover.AsSpan(first, last + 1 - first).Contains(Nothing);
    }

    private static MoonRegion RegionOf(LdemLabel label)
    {
        MoonRegion region = new((int)label.SouthDegrees, (int)label.NorthDegrees, (int)label.WestDegrees, (int)label.EastDegrees);
        bool isWhole = (region.SouthDegrees, region.NorthDegrees, region.WestDegrees, region.EastDegrees)
            == (label.SouthDegrees, label.NorthDegrees, label.WestDegrees, label.EastDegrees);
        return isWhole && region.IsValid ? region : throw new BadInputException(Invariant(
            $"{label.LabelPath}: covers latitudes {label.SouthDegrees:R} to {label.NorthDegrees:R} and longitudes {label.WestDegrees:R} "
                + $"to {label.EastDegrees:R} degrees; parts of a model have borders of whole degrees, and latitudes in -90 to 90."));
    }

    /// <summary>The error that names the missing parts, on the raster that the known borders make.</summary>
    private static BadInputException Incomplete(IReadOnlyList<LdemLabel> parts, ushort[] cover)
    {
        int height = 180;
        int width = 360;
        foreach (MoonRegion region in parts.Select(RegionOf))
        {
            height = MaxDivisor(MaxDivisor(height, region.NorthDegrees + 90), region.SouthDegrees + 90);
            width = MaxDivisor(MaxDivisor(width, region.WestDegrees), region.EastDegrees);
        }

        LdemPartName name = LdemPartName.Of(parts[0]);
        string[] missing =
        [
            .. from north in Enumerable.Range(0, 180 / height).Select(row => 90 - (row * height))
               from west in Enumerable.Range(0, 360 / width).Select(column => column * width)
               where cover[((90 - north) * 360) + west] == Nothing
               select name.ForRegion(new MoonRegion(north - height, north, west, west + width)),
        ];
        return new BadInputException(
            $"{FileNames.FolderOf(parts[0].LabelPath)}: of the {name.Before} product in several files {missing.Length} are missing: "
                + $"{FileNames.Listed(missing)}. Put their .LBL and .IMG files beside {Path.GetFileName(parts[0].LabelPath)}; "
                + $"the whole Moon is needed. Each part that is there is a map of its own: name it with --ldem, over a model of the whole "
                + $"Moon.");
    }

    private static int MaxDivisor(int a, int b) => b == 0 ? a : MaxDivisor(b, a % b);
}

/// <summary>
/// The name of a part of a split product: the archive puts the part's borders into it, e.g. "LDEM_512_00N_45N_000_090_FLOAT".
/// </summary>
/// <param name="Before">What is before the borders, e.g. "LDEM_512"; the whole name if it has none.</param>
/// <param name="After">What is behind them, e.g. "_FLOAT".</param>
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
        : Invariant(
            $"latitudes {region.SouthDegrees} to {region.NorthDegrees}, longitudes {region.WestDegrees} to {region.EastDegrees}");

    /// <summary>Borders as the archive writes them: "00N_45N_000_090".</summary>
    public static string BordersOf(MoonRegion region) => Invariant(
        $"{Latitude(region.SouthDegrees, region)}_{Latitude(region.NorthDegrees, region)}_"
            + $"{region.WestDegrees:000}_{region.EastLongitude:000}");

    // The equator is 00N, except as the northern border of a southern region.
    private static string Latitude(int degrees, MoonRegion region)
    {
        bool south = degrees < 0 || (degrees == 0 && region.NorthDegrees == 0);
        return Invariant($"{Math.Abs(degrees):00}{(south ? 'S' : 'N')}");
    }

    [GeneratedRegex("_[0-9]{1,2}[NS]_[0-9]{1,2}[NS]_[0-9]{1,3}_[0-9]{1,3}", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Borders();
}
