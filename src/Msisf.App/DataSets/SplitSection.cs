using System.Text.RegularExpressions;
using Msisf.Adapters.Input;

namespace Msisf.App.DataSets;

/// <summary>
/// Reads how a data set is split: by shares, whose regions are lunes between meridians in turn, or by a region of each split.
/// </summary>
internal static partial class SplitSection
{
    public const string Key = "split";

    /// <summary>Name of the only split of a data set that has no others.</summary>
    public const string All = "all";

    private const string Width = "width";
    private const string Gap = "gap";

    /// <summary>degrees of longitude: a lune of some hundred kilometres, so that each split has maria and highlands.</summary>
    private const double DefaultWidth = 15.0;

    /// <summary>degrees of longitude between two lunes.</summary>
    private const double DefaultGap = 1.0;

    /// <param name="file">The data set's file.</param>
    /// <param name="section">The section; null for one split.</param>
    /// <param name="states">The section of the states, which has the region of all.</param>
    /// <param name="keys">The section's keys in their order.</param>
    /// <param name="count">Number of images, or of pairs.</param>
    /// <returns>The splits, and to which of them each image, or pair, belongs.</returns>
    public static (IReadOnlyList<Split> Splits, IReadOnlyList<int> Order) Read(
        SettingsSection file, SettingsSection? section, SettingsSection states, IReadOnlyList<string> keys, int count)
    {
        Region whole = RegionOf(states);
        if (section is null)
        {
            return file.Has(Key)
                ? throw file.Wrong(Key, "'split' is a section: put its keys below it, each in a line of its own and indented")
                : ([new Split(All, count, [whole], IsBound: false)], new int[count]);
        }

        string[] names = [.. keys.Where(key => key is not (Width or Gap))];
        if (names.FirstOrDefault(name => !NameText().IsMatch(name)) is { } wrong)
        {
            throw section.Wrong(wrong, $"{NumberText.Shown(wrong)} is not a name of a split: letters, digits, '-' and '_' are possible");
        }

        if (names.Length == 0)
        {
            throw file.Wrong(Key, "'split' names no split, e.g. train: 0.8");
        }

        bool hasRegions = section.IsList(names[0]);
        if (names.FirstOrDefault(name => section.IsList(name) != hasRegions) is { } other)
        {
            throw section.Wrong(other, "of the splits some have a share, some a region. Give all of them the same");
        }

        return hasRegions ? OfRegions(section, states, names, count) : OfShares(section, names, whole, count);
    }

    private static Region RegionOf(SettingsSection states)
    {
        double[] latitude = states.Numbers("latitude", 2, 2) ?? [-90.0, 90.0];
        double[] longitude = states.Numbers("longitude", 2, 2) ?? [0.0, 360.0];
        return Checked(new Region(latitude[0], latitude[1], longitude[0], longitude[1]))
            ?? throw states.Wrong(states.Has("latitude") ? "latitude" : "longitude", Needed);
    }

    private const string Needed =
        "latitudes from south to north within -90 and 90 are needed, and longitudes from west to east, at most 360 degrees apart";

    private static Region? Checked(Region region) =>
        region.South >= -90.0 && region.South < region.North && region.North <= 90.0 && region.West < region.East
        && region.East - region.West <= 360.0 && Math.Abs(region.West) <= 360.0
            ? region
            : null;

    private static (IReadOnlyList<Split> Splits, IReadOnlyList<int> Order) OfRegions(
        SettingsSection section, SettingsSection states, string[] names, int count)
    {
        if (section.Has(Width) || section.Has(Gap) || states.Has("latitude") || states.Has("longitude"))
        {
            throw section.Wrong(
                names[0], "the splits have regions of their own; 'width' and 'gap', and 'latitude' and 'longitude' of the states, are of "
                    + "no use then. Leave them out");
        }

        Region[] regions = [.. names.Select(name =>
        {
            double[] borders = section.Numbers(name, 4, 4)!;
            return Checked(new Region(borders[0], borders[1], borders[2], borders[3])) ?? throw section.Wrong(name, $"'{name}': {Needed}");
        })];
        for (int i = 0; i < names.Length; i++)
        {
            for (int j = 0; j < i; j++)
            {
                if (regions[i].Touches(regions[j]))
                {
                    throw section.Wrong(names[i], $"the regions of '{names[j]}' and '{names[i]}' touch. Leave a gap between them");
                }
            }
        }

        double area = regions.Sum(region => region.Area);
        return Of(
            names, [.. regions.Select(region => region.Area / area)], [.. regions.Select(region => new List<Region> { region })], count);
    }

    private static (IReadOnlyList<Split> Splits, IReadOnlyList<int> Order) OfShares(
        SettingsSection section, string[] names, Region whole, int count)
    {
        double[] shares = [.. names.Select(name => section.Positive(name)!.Value)];
        double sum = shares.Sum();
        if (Math.Abs(sum - 1.0) > 1e-6)
        {
            throw section.Wrong(names[0], Invariant($"the shares of the splits add up to {sum:R}, not to 1"));
        }

        double width = section.Positive(Width) ?? DefaultWidth;
        double gap = section.Positive(Gap) ?? DefaultGap;
        int lunes = Math.Max(names.Length, (int)Math.Round((whole.East - whole.West) / width));
        width = (whole.East - whole.West) / lunes;
        if (gap >= width)
        {
            throw section.Wrong(section.Has(Gap) ? Gap : names[0], Invariant(
                $"the regions of the splits are {width:G4} degrees of longitude wide, and the gap between them is {gap:R}. Make that "
                    + $"smaller, or the region wider"));
        }

        List<Region>[] regions = [.. names.Select(_ => new List<Region>())];
        for (int lune = 0; lune < lunes; lune++)
        {
            double west = whole.West + (lune * width);
            int last = Enumerable.Range(0, names.Length).MaxBy(index => (shares[index] * (lune + 1)) - regions[index].Count);
            regions[last].Add(whole with { West = west + (0.5 * gap), East = west + width - (0.5 * gap) });
        }

        return regions.ToList().FindIndex(list => list.Count == 0) is >= 0 and int empty
            ? throw section.Wrong(
                names[empty], $"the share of '{names[empty]}' is smaller than one of {lunes} regions. Make 'width' smaller")
            : Of(names, shares, regions, count);
    }

    private static (IReadOnlyList<Split> Splits, IReadOnlyList<int> Order) Of(
        string[] names, double[] parts, List<Region>[] regions, int count)
    {
        int[] order = Split.OrderOf(parts, count);
        return (
            [.. names.Select((name, index) => new Split(name, order.Count(split => split == index), regions[index], IsBound: true))],
            order);
    }

    [GeneratedRegex(@"^[A-Za-z][A-Za-z0-9_-]{0,40}\z")]
    private static partial Regex NameText();
}
