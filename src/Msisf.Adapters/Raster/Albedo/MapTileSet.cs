namespace Msisf.Adapters.Raster.Albedo;

/// <summary>The tiles of one map that lie in a folder.</summary>
/// <param name="Name">What the tiles' names have in common, e.g. "WAC_EMP_643NM_304P".</param>
/// <param name="Labels">Their labels, by name.</param>
/// <param name="LeftOut">Names of the map's tiles around the poles, which are not equirectangular.</param>
internal sealed record MapTileSet(string Name, IReadOnlyList<PdsMapLabel> Labels, IReadOnlyList<string> LeftOut)
{
    private static readonly string[] Extensions = [".IMG", ".LBL"];

    /// <summary>The tiles that belong to a tile, with itself; those of other products and bands don't.</summary>
    /// <param name="tile">One of them.</param>
    /// <exception cref="BadInputException">Another tile of the map can't be read.</exception>
    public static MapTileSet WithSiblings(PdsMapLabel tile)
    {
        string folder = FileNames.FolderOf(tile.LabelPath);
        return PdsMapHead.IsTile(tile.Head.Product) && !tile.Extent.IsFullCircle
            ? Read(tile.Head.Map, folder, [tile], [.. MapsIn(folder).Where(map => IsTileOf(map.Product, tile.Head.Map))])
            : new MapTileSet(tile.Head.Map, [tile], []);
    }

    /// <summary>The map in a folder that has the band.</summary>
    /// <param name="bandNanometres">The band; a map without a band in its name has any.</param>
    /// <exception cref="BadInputException">There is none, or several, or a tile of it can't be read.</exception>
    public static MapTileSet InFolder(string folder, int bandNanometres)
    {
        IGrouping<string, PdsMapHead>[] maps =
        [
            .. MapsIn(folder).Where(map => !map.Product.StartsWith("WAC_HAPKEPARAM", StringComparison.OrdinalIgnoreCase))
                .GroupBy(map => map.Map, StringComparer.Ordinal)
                .OrderBy(map => map.Key, StringComparer.Ordinal),
        ];
        IGrouping<string, PdsMapHead>[] wanted =
            [.. maps.Where(map => map.First().BandNanometres is not int band || band == bandNanometres)];
        return wanted switch
        {
            [var only] => Read(only.Key, folder, [], [.. only]),
            [] when maps.Length == 0 => throw new BadInputException(
                $"{folder}: no map with a PDS3 label is in this folder. Give a map's file, or the folder of its tiles."),
            [] => throw new BadInputException(
                $"{folder}: no map at {bandNanometres} nm is in this folder, only {FileNames.Listed(maps.Select(map => map.Key))}. "
                    + $"Choose a band with --band, or give another folder."),
            _ => throw new BadInputException(
                $"{folder}: several maps are in this folder: {FileNames.Listed(wanted.Select(map => map.Key))}. "
                    + $"Give one tile of the wanted one, or put it into a folder of its own."),
        };
    }

    private static MapTileSet Read(string name, string folder, PdsMapLabel[] given, PdsMapHead[] found)
    {
        foreach (string path in FilesIn(folder).Where(path => IsTileOf(Path.GetFileNameWithoutExtension(path), name)))
        {
            PdsMapHead.TryRead(path); // a tile with a damaged label is an error, not a place without a tile
        }

        PdsMapHead[] polar = [.. found.Where(tile => tile.IsPolar)];
        PdsMapLabel[] labels =
        [
            .. given.Concat(found.Where(tile => !tile.IsPolar).Select(PdsMapLabel.Read))
                .DistinctBy(label => Path.GetFullPath(label.ImagePath)),
        ];
        return labels.Length > 0
            ? new MapTileSet(name, labels, [.. polar.Select(tile => Path.GetFileName(tile.LabelPath))])
            : throw new BadInputException(
                $"{polar[0].LabelPath}: of {name} only polar stereographic tiles are here, which are not read. Get its "
                    + $"equirectangular tiles.");
    }

    private static bool IsTileOf(string product, string map) => PdsMapHead.IsTile(product) && PdsMapHead.MapOf(product) == map;

    /// <summary>The maps of a folder, which may hold other files too.</summary>
    private static IEnumerable<PdsMapHead> MapsIn(string folder) =>
        FilesIn(folder).Select(PdsMapHead.TryReadMap).OfType<PdsMapHead>().DistinctBy(map => map.LabelPath);

    private static IEnumerable<string> FilesIn(string folder) => FileErrors.ToBadInput(
            $"{folder}: the folder can't be read", () => Directory.GetFiles(folder))
        .Where(path => Extensions.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase))
        .Order(StringComparer.Ordinal);
}
