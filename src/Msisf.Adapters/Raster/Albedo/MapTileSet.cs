using System.Globalization;
using Msisf.Core.Errors;

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
        MapTileName name = MapTileName.Of(tile.Product);
        return name.HasCentre && !tile.Extent.IsFullCircle
            ? Read(name.Map, FolderOf(tile.LabelPath), [tile], [.. TilesBeside(tile, name)])
            : new MapTileSet(name.Map, [tile], []);
    }

    /// <summary>The map in a folder that has the band.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="bandNanometres">The band; a map without a band in its name has any.</param>
    /// <exception cref="BadInputException">There is none, or several, or a tile of it can't be read.</exception>
    public static MapTileSet InFolder(string folder, int bandNanometres)
    {
        IGrouping<string, PdsMapHead>[] maps =
        [
            .. Maps(folder).Where(map => !map.Product.StartsWith("WAC_HAPKEPARAM", StringComparison.OrdinalIgnoreCase))
                .GroupBy(map => MapTileName.Of(map.Product).Map, StringComparer.Ordinal)
                .OrderBy(map => map.Key, StringComparer.Ordinal),
        ];
        IGrouping<string, PdsMapHead>[] wanted =
            [.. maps.Where(map => map.First().BandNanometres is not int band || band == bandNanometres)];
        return wanted switch
        {
            [var only] => Read(only.Key, folder, [], [.. only]),
            [] when maps.Length == 0 => throw new BadInputException(
                $"{folder}: no map with a PDS3 label is in this folder. Give a map's file, or the folder of its tiles."),
            [] => throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{folder}: no map at {bandNanometres} nm is in this folder, only {FileNames.Listed(maps.Select(map => map.Key))}. "
                    + $"Choose a band with --band, or give another folder.")),
            _ => throw new BadInputException(
                $"{folder}: several maps are in this folder: {FileNames.Listed(wanted.Select(map => map.Key))}. "
                    + $"Give one tile of the wanted one, or put it into a folder of its own."),
        };
    }

    private static MapTileSet Read(string name, string folder, PdsMapLabel[] given, PdsMapHead[] found)
    {
        foreach (string path in Files(folder).Where(path => IsTileOf(Path.GetFileNameWithoutExtension(path), name)))
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

    private static bool IsTileOf(string product, string map) =>
        MapTileName.Of(product) is { HasCentre: true } other && other.Map == map;

    private static IEnumerable<PdsMapHead> TilesBeside(PdsMapLabel tile, MapTileName name) =>
        Maps(FolderOf(tile.LabelPath)).Where(map => IsTileOf(map.Product, name.Map));

    /// <summary>The maps of a folder, which may hold other files too.</summary>
    private static IEnumerable<PdsMapHead> Maps(string folder) => Files(folder)
        .Select(PdsMapHead.TryReadMap)
        .OfType<PdsMapHead>()
        .DistinctBy(map => map.LabelPath);

    private static IEnumerable<string> Files(string folder) => FileErrors.ToBadInput(
            $"{folder}: the folder can't be read", () => Directory.GetFiles(folder))
        .Where(path => Extensions.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase))
        .Order(StringComparer.Ordinal);

    private static string FolderOf(string path) => Path.GetDirectoryName(path) is { Length: > 0 } folder ? folder : ".";
}
