using Msisf.Core.Metadata;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map of the Moon's reflectance that is ready to be drawn with; don't use its map after it is disposed.</summary>
public sealed class OpenedAlbedoMap : IDisposable
{
    private readonly MapLevelsFile _levels;
    private readonly string _path;
    private readonly MapProperties _properties;
    private AlbedoMap? _map;

    private OpenedAlbedoMap(string path, PdsMapFiles? tiles, MapProperties properties, MapLevelsFile levels)
    {
        (_path, _properties, _levels) = (path, properties, levels);
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

    /// <summary>Several maps as one input: the name and length of the coarsest; the checksum is made of theirs.</summary>
    public static InputFile WholeOf(IReadOnlyList<OpenedAlbedoMap> maps) => maps[0].Whole with
    {
        Sha256 = Convert.ToHexStringLower(MapFiles.HashOf([.. maps.Select(map => map._levels.Header.SourceHash)])),
    };

    /// <summary>What the user should know of the map: tiles that are left out, or a resolution that is too fine.</summary>
    public IReadOnlyList<string> Notes { get; }

    /// <summary>
    /// SHA-256 of the file: 64 hexadecimal digits. For several tiles it is that of their SHA-256, written one after the other.
    /// </summary>
    public string Sha256 { get; }

    /// <summary>The map.</summary>
    public AlbedoMap Map => _map ??= Describe();

    /// <summary>
    /// By what the map's values are multiplied to be those of the map around it; null for a map that has its own reflectances.
    /// </summary>
    public double? Factor { get; private set; }

    /// <summary>Latitude that a pixel covers, rad: what tells which of several maps is the finest.</summary>
    private double PixelHeight => (_levels.Header.Extent?.Height ?? Math.PI) / _levels.Header.Height;

    /// <summary>Whether a file is a map whose properties the program knows without any option.</summary>
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
        OpenedAlbedoMap opened = OpenLevels(path, given, bandNanometres, cacheFolder, gdalPath);
        try
        {
            _ = opened.Map;
            return opened;
        }
        catch
        {
            opened.Dispose();
            throw;
        }
    }

    /// <summary>Opens maps of which the finest counts where it has data; the others are scaled to those around them.</summary>
    /// <param name="paths">The maps, in any order.</param>
    /// <returns>The maps, the coarsest first.</returns>
    /// <param name="bandNanometres">The band that is wanted, nm.</param>
    /// <param name="cacheFolder">The user's cache folder of this program; null if there is none.</param>
    /// <param name="gdalPath">MSISF_GDAL, or null.</param>
    /// <inheritdoc cref="Open" path="/exception"/>
    public static IReadOnlyList<OpenedAlbedoMap> OpenSeveral(
        IEnumerable<AlbedoMapPath> paths, int bandNanometres, string? cacheFolder, string? gdalPath)
    {
        List<(OpenedAlbedoMap Map, AlbedoMapPath Given)> maps = [];
        try
        {
            foreach (AlbedoMapPath path in paths)
            {
                maps.Add((OpenLevels(path.Path, path.Properties, bandNanometres, cacheFolder, gdalPath), path));
            }

            maps = [.. maps.OrderByDescending(map => map.Map.PixelHeight).ThenBy(map => map.Map.Sha256, StringComparer.Ordinal)];
            for (int i = 0; i < maps.Count; i++)
            {
                maps[i].Map.FitInto([.. maps[..i].Select(map => map.Map.Map).Reverse()], maps[i].Given);
            }

            return [.. maps.Select(map => map.Map)];
        }
        catch
        {
            maps.ForEach(map => map.Map.Dispose());
            throw;
        }
    }

    private static OpenedAlbedoMap OpenLevels(
        string path, MapProperties given, int bandNanometres, string? cacheFolder, string? gdalPath)
    {
        if (!File.Exists(path) && !Directory.Exists(path))
        {
            throw new BadInputException($"{path}: there is no such file. Give a map, or none.");
        }

        PdsMapHead? other = File.Exists(path) && PdsMapHead.TryRead(path) is { IsForGdal: true } head ? head : null;
        PdsMapFiles? tiles = other is null ? PdsMapFiles.TryFind(path, bandNanometres) : null;
        MapProperties known = tiles is not null ? KnownMaps.Of(tiles.Label)
            : other is not null ? KnownMaps.Of(other)
            : KnownMaps.IsColourMap(path) && given.Scale is null ? KnownMaps.ColourMap(path, bandNanometres)
            : KnownMaps.IsColourMap(path) ? KnownMaps.ColourMap(path, 643) with { BandNanometres = null }
            : new MapProperties { Offset = 0.0 };
        MapProperties properties = given.Or(known);
        if (properties.BandNanometres is double band && band != bandNanometres)
        {
            throw new BadInputException(Invariant(
                $"{path}: a map at {band:R} nm, but --band is {bandNanometres}. Give --band {band:R} or another map."));
        }

        MapLevelsFile levels = MapLevelsFile.Open(
            tiles?.Files ?? new MapFiles(path, [other?.ImagePath ?? path]), cacheFolder,
            () => tiles?.OpenSource() ?? (MapSource?)JpegMapSource.TryOpen(path) ?? GdalMapSource.Open(other?.LabelPath ?? path, gdalPath));
        return new OpenedAlbedoMap(path, tiles, properties, levels);
    }

    /// <summary>Releases the map's pages that were read; they are mapped again when they are read again.</summary>
    public void ReleasePages() => _levels.ReleasePages();

    /// <summary>Unmaps the levels.</summary>
    public void Dispose() => _levels.Dispose();

    /// <summary>Scales a map to those around it, unless its values are known to be reflectances in a known geometry.</summary>
    /// <param name="coarser">The coarser maps, the finest first.</param>
    /// <param name="given">How the user has it scaled.</param>
    private void FitInto(IReadOnlyList<AlbedoMap> coarser, AlbedoMapPath given)
    {
        bool isKnown = _properties is { Scale: not null, Reference: not null };
        if (!given.IsMatched && isKnown)
        {
            _map = given.Factor is { } times ? Map.Scaled(times, Map.Reference) : Map;
            return;
        }

        if (coarser.Count == 0 && !given.IsMatched && given.Factor is null)
        {
            _ = Map; // says what is not known of it
        }

        AlbedoMap own = OfValues(_properties.Scale ?? 1.0, default);
        if (AlbedoMatch.Of(own, coarser) is not { } match)
        {
            throw new BadInputException(
                $"{_path}: no coarser map shows the half of its border, so its brightness can't be taken from there. Give a map around it "
                    + $"too, or what its values are: ,scale=...,incidence=...,emission=...,phase=... behind the path.");
        }

        double factor = given.Factor ?? match.Factor;
        Factor = factor > 0.0 && double.IsFinite(factor) ? factor : throw new BadInputException(
            $"{_path}: its values along the border are 0 or below in the mean, so they can't be scaled to the map around. Give offset=, "
                + $"or declare what is no data, e.g. with gdal_edit.py -a_nodata 0.");
        _map = own.Scaled(factor, _properties.Reference is { } reference && !given.IsMatched ? reference : match.Around.Reference);
    }

    private AlbedoMap Describe()
    {
        ReferenceGeometry reference = _properties.Reference ?? throw Unknown(_path, "incidence, emission and phase angle");
        if (Math.Abs(reference.IncidenceDegrees - reference.EmissionDegrees) > reference.PhaseDegrees
            || reference.IncidenceDegrees + reference.EmissionDegrees < reference.PhaseDegrees)
        {
            throw new BadInputException(Invariant(
                $"{_path}: no surface has incidence {reference.IncidenceDegrees:R}, emission {reference.EmissionDegrees:R} and phase angle "
                    + $"{reference.PhaseDegrees:R} degrees. Correct --albedo-map-properties."));
        }

        return OfValues(_properties.Scale ?? throw Unknown(_path, "scale"), reference);
    }

    /// <summary>The map, its values being reflectances but for a factor.</summary>
    private AlbedoMap OfValues(double scale, ReferenceGeometry reference)
    {
        MapLevelsHeader header = _levels.Header;
        MapExtent extent = header.Extent ?? WholeMoon(_path, header, _properties.WestDegrees ?? throw Unknown(_path, "left edge (west)"));
        extent = _properties.WestDegrees is double left ? extent with { West = double.DegreesToRadians(left) } : extent;
        return new AlbedoMap(
            _levels.Levels, extent, (scale * header.Offset) + (_properties.Offset ?? 0.0), scale * header.Step, reference);
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
