using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Preparation;

/// <summary>Finds and opens the map of the Moon's reflectance that a run draws with.</summary>
internal static class AlbedoSource
{
    /// <summary>Ends of the names of images.</summary>
    private static readonly string[] Images = [".tif", ".tiff", ".img", ".cub", ".jp2", ".vrt", ".jpg", ".jpeg", ".png"];

    /// <summary>Opens the maps, the coarsest first; none if the run has none. What is used is logged.</summary>
    /// <exception cref="MsisfException">A map is given, but can't be used.</exception>
    public static IReadOnlyList<OpenedAlbedoMap> Open(RenderSettings settings, ProgramHost host)
    {
        AlbedoSettings albedo = settings.Albedo;
        if (albedo.Maps.Count > 0)
        {
            return AlbedoOptions.Map.NamedInErrors(() => Open(
                [.. albedo.Maps.Select(map => map with { Path = Find(map.Path, host) })], albedo, host));
        }

        bool isMoon = settings.Renderer == RendererKind.Native && settings.Native.ReflectanceText == ReflectanceFactory.DefaultLaw;
        if (isMoon && !settings.Body.IsMoon)
        {
            host.Log.Note(
                $"Reflectance: {settings.Body.Name} is drawn with the law of the Moon, the same everywhere; its own is not known here. "
                    + $"--reflectance takes another law.");
            return [];
        }

        if (albedo.IsGiven || !isMoon)
        {
            return [];
        }

        if (Installed(Folders(host), albedo.Band) is not { } installed)
        {
            host.Log.Note(
                "Albedo: no map in input/albedo ('msis fetch albedo' gets one); the surface reflects alike everywhere.");
            return [];
        }

        try
        {
            return Open([AlbedoMapPath.Parse(installed) with { Path = installed }], albedo, host);
        }
        catch (ExternalPartException exception)
        {
            host.Log.Warning($"{exception.Message} The map is not used: the surface reflects alike everywhere.");
            return [];
        }
    }

    /// <summary>
    /// The images where maps are searched, those of the first folder first: of reflectance, whether its scale is known or not, as of
    /// ortho-images of sites, and of Hapke's parameters.
    /// </summary>
    public static IEnumerable<string> Maps(ProgramHost host) => Folders(host).Where(Directory.Exists)
        .SelectMany(folder => Directory.EnumerateFiles(folder).Order(StringComparer.Ordinal))
        .Where(path => Images.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase) || OpenedAlbedoMap.IsKnown(path));

    /// <summary>Folders in which maps are searched if no path is given, in the order of the search.</summary>
    private static IReadOnlyList<string> Folders(ProgramHost host) => new DataFolders(DataFolders.Albedo, host).Searched;

    /// <summary>The path of a given map or folder; a plain name is also looked for where maps are installed.</summary>
    private static string Find(string given, ProgramHost host) => Path.Exists(given) || Path.GetFileName(given) != given
        ? given
        : Folders(host).Select(folder => Path.Combine(folder, given)).FirstOrDefault(Path.Exists) ?? given;

    /// <summary>
    /// The largest known map of a band in the first folder that has one; or one of another band, which is then refused; null if there is
    /// none.
    /// </summary>
    internal static string? Installed(IEnumerable<string> folders, SpectralBand band)
    {
        string[] known =
        [
            .. folders.Where(Directory.Exists).SelectMany(folder => Directory.EnumerateFiles(folder)
                .Where(path => OpenedAlbedoMap.IsKnown(path))
                .OrderByDescending(path => new FileInfo(path).Length)
                .ThenBy(path => path, StringComparer.Ordinal)),
        ];
        return known.FirstOrDefault(path => OpenedAlbedoMap.IsKnown(path, band.Nanometres)) ?? known.FirstOrDefault();
    }

    private static IReadOnlyList<OpenedAlbedoMap> Open(IReadOnlyList<AlbedoMapPath> paths, AlbedoSettings albedo, ProgramHost host)
    {
        (int band, string? gdal) = (albedo.Band.Nanometres, host.Environment("MSISF_GDAL"));
        IReadOnlyList<OpenedAlbedoMap> maps = paths is [var only]
            ? [OpenedAlbedoMap.Open(only.Path, albedo.Properties, band, host.CacheFolder, gdal)]
            : OpenedAlbedoMap.OpenSeveral(paths, band, host.CacheFolder, gdal);
        if (albedo.Sha256 is { } expected && OpenedAlbedoMap.WholeOf(maps) is var whole && expected != whole.Sha256)
        {
            foreach (OpenedAlbedoMap map in maps)
            {
                map.Dispose();
            }

            throw new BadInputException(
                $"{string.Join(" and ", paths.Select(path => path.Path))}: the SHA-256 is {whole.Sha256}, but --albedo-map-checksum is "
                    + $"{expected}. Give the map that was meant.")
                .About(AlbedoOptions.Checksum);
        }

        foreach (OpenedAlbedoMap map in maps)
        {
            Tell(map, host.Log);
        }

        return maps;
    }

    private static void Tell(OpenedAlbedoMap map, ILog log)
    {
        foreach (string note in map.Notes)
        {
            log.Note($"Albedo: {note}");
        }

        log.Note($"Albedo: {map.Name}, {map.Map.Levels[0].Width} x {map.Map.Levels[0].Height} px.");
        if (map.Factor is { } factor)
        {
            log.Note(Invariant($"Its values times {factor:G6} count as reflectances in the geometry of the map around it."));
        }
    }
}
