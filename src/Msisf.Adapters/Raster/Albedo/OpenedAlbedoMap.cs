using System.Globalization;
using Msisf.Adapters.Interop;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map of the Moon's reflectance that is ready to be drawn with; don't use its map after it is disposed.</summary>
public sealed class OpenedAlbedoMap : IDisposable
{
    private readonly MapLevelsFile _levels;

    private OpenedAlbedoMap(string path, PdsMapFiles? tiles, AlbedoMap map, MapLevelsFile levels)
    {
        Map = map;
        _levels = levels;
        Sha256 = Convert.ToHexStringLower(levels.Header.SourceHash);
        string[] names = tiles is { Files.Paths: var paths } && (paths.Count > 1 || Directory.Exists(path))
            ? [.. paths.Select(tile => Path.GetFileName(tile))]
            : [Path.GetFileName(path)];
        Name = names.Length > 1 ? tiles!.Name : names[0];
        Files =
        [
            .. names.Zip(levels.Header.FileHashes, (name, hash) => (name, hash)).Select((file, i) => new InputFile(
                InputKind.AlbedoMap,
                file.name,
                names.Length == 1 ? levels.Header.SourceBytes : new FileInfo(tiles!.Files.Paths[i]).Length,
                Convert.ToHexStringLower(file.hash))),
        ];
        Notes = tiles?.Notes ?? [];
    }

    /// <summary>The map's name, for messages.</summary>
    public string Name { get; }

    /// <summary>The map's file; of several tiles each, from the north, then from the west.</summary>
    public IReadOnlyList<InputFile> Files { get; }

    /// <summary>The map as one input: its file; of several tiles the first one, with the length and the checksum of all.</summary>
    public InputFile Whole => Files[0] with { Bytes = _levels.Header.SourceBytes, Sha256 = Sha256 };

    /// <summary>What the user should know of the map: tiles that are left out, or a resolution that is too fine.</summary>
    public IReadOnlyList<string> Notes { get; }

    /// <summary>
    /// SHA-256 of the file: 64 hexadecimal digits. Of several tiles it is that of the tiles' SHA-256, written one after the other.
    /// </summary>
    public string Sha256 { get; }

    /// <summary>The map.</summary>
    public AlbedoMap Map { get; }

    /// <summary>Whether a file is a map whose properties the program knows without any option.</summary>
    /// <param name="path">The file.</param>
    /// <param name="bandNanometres">The band in which they must be known, nm; null for any.</param>
    public static bool IsKnown(string path, int? bandNanometres = null)
    {
        try
        {
            return KnownMaps.IsColourMap(path)
                ? bandNanometres is not int wanted || KnownMaps.HasColourMap(wanted)
                : PdsMapLabel.TryRead(path) is { } label && KnownMaps.Of(label).Reference is not null
                    && (label.Head.BandNanometres ?? bandNanometres) == (bandNanometres ?? label.Head.BandNanometres);
        }
        catch (BadInputException)
        {
            return false;
        }
    }

    /// <summary>Opens a map. The first time its levels are made and kept in the cache folder.</summary>
    /// <param name="path">A PDS3 image or its label, one of several tiles or their folder, or any image that GDAL reads.</param>
    /// <param name="given">Properties that the user gives; they count before those that are known.</param>
    /// <param name="bandNanometres">The band that is wanted, nm.</param>
    /// <param name="cacheFolder">The user's cache folder of this program; null if there is none.</param>
    /// <param name="gdalPath">MSISF_GDAL, or null.</param>
    /// <exception cref="BadInputException">The map can't be read, is of another band, or a property of it is not known.</exception>
    /// <exception cref="ExternalPartException">GDAL is needed and missing, or the file system refuses.</exception>
    public static OpenedAlbedoMap Open(string path, MapProperties given, int bandNanometres, string? cacheFolder, string? gdalPath)
    {
        if (!File.Exists(path) && !Directory.Exists(path))
        {
            throw new BadInputException($"{path}: there is no such file. Give a map, or none.");
        }

        PdsMapFiles? tiles = PdsMapFiles.TryFind(path, bandNanometres);
        MapProperties known = tiles is not null ? KnownMaps.Of(tiles.Label)
            : KnownMaps.IsColourMap(path) && given.Scale is null ? KnownMaps.ColourMap(path, bandNanometres)
            : KnownMaps.IsColourMap(path) ? KnownMaps.ColourMap(path, 643) with { BandNanometres = null }
            : new MapProperties { Offset = 0.0 };
        MapProperties properties = given.Or(known);
        if (properties.BandNanometres is double band && band != bandNanometres)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{path}: a map at {band:R} nm, but --band is {bandNanometres}. Give --band {band:R} or another map."));
        }

        MapLevelsFile levels = MapLevelsFile.Open(
            tiles?.Files ?? new MapFiles(path, [path]), cacheFolder,
            () => tiles?.OpenSource() ?? new GdalMapSource(GdalImage.Open(path, gdalPath)));
        try
        {
            return new OpenedAlbedoMap(path, tiles, Describe(path, levels, properties), levels);
        }
        catch
        {
            levels.Dispose();
            throw;
        }
    }

    /// <summary>Releases the map's pages that were read; they are mapped again when they are read again.</summary>
    public void ReleasePages() => _levels.ReleasePages();

    /// <summary>Unmaps the levels.</summary>
    public void Dispose() => _levels.Dispose();

    private static AlbedoMap Describe(string path, MapLevelsFile levels, MapProperties properties)
    {
        MapLevelsHeader header = levels.Header;
        ReferenceGeometry reference = properties.Reference ?? throw Unknown(path, "incidence, emission and phase angle");
        if (Math.Abs(reference.IncidenceDegrees - reference.EmissionDegrees) > reference.PhaseDegrees
            || reference.IncidenceDegrees + reference.EmissionDegrees < reference.PhaseDegrees)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{path}: no surface has incidence {reference.IncidenceDegrees:R}, emission {reference.EmissionDegrees:R} and phase angle "
                    + $"{reference.PhaseDegrees:R} degrees. Correct --albedo-map-properties."));
        }

        double scale = properties.Scale ?? throw Unknown(path, "scale");
        MapExtent extent = header.Extent ?? WholeMoon(path, header, properties.WestDegrees ?? throw Unknown(path, "left edge (west)"));
        extent = properties.WestDegrees is double left ? extent with { West = double.DegreesToRadians(left) } : extent;
        return new AlbedoMap(
            levels.Levels, extent, (scale * header.Offset) + (properties.Offset ?? 0.0), scale * header.Step, reference);
    }

    private static MapExtent WholeMoon(string path, MapLevelsHeader header, double west) =>
        Math.Abs(header.Width - (2 * header.Height)) <= 2
            ? new MapExtent(double.DegreesToRadians(west), Math.PI / 2.0, 2.0 * Math.PI, Math.PI)
            : throw new BadInputException(
                $"{path}: {header.Width} x {header.Height} pixels and no map coordinates; "
                    + $"a map of the whole Moon is twice as wide as high.");

    private static BadInputException Unknown(string path, string what) => new(
        $"{path}: its {what} is not known. Give --albedo-map-properties, e.g. "
            + $"scale=3.16e-4,west=-180,incidence=60,emission=0,phase=60.");
}
