using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Albedo;

/// <summary>A map of the Moon's reflectance that is ready to be drawn with; don't use its map after it is disposed.</summary>
public sealed class OpenedAlbedoMap : IDisposable
{
    private readonly MapLevelsFile _levels;

    private OpenedAlbedoMap(string path, AlbedoMap map, MapLevelsFile levels)
    {
        FilePath = path;
        Map = map;
        _levels = levels;
        Sha256 = Convert.ToHexStringLower(levels.Header.SourceHash);
    }

    /// <summary>The map's file.</summary>
    public string FilePath { get; }

    /// <summary>Length of the file.</summary>
    public long FileBytes => _levels.Header.SourceBytes;

    /// <summary>SHA-256 of the file: 64 hexadecimal digits.</summary>
    public string Sha256 { get; }

    /// <summary>The map.</summary>
    public AlbedoMap Map { get; }

    /// <summary>Whether a file is a map whose properties the program knows without any option.</summary>
    /// <param name="path">The file.</param>
    public static bool IsKnown(string path)
    {
        try
        {
            return KnownMaps.IsColourMap(path) || (PdsMapLabel.TryRead(path) is { } label && KnownMaps.Of(label).Reference is not null);
        }
        catch (BadInputException)
        {
            return false;
        }
    }

    /// <summary>Opens a map. The first time its levels are made and kept in the cache folder.</summary>
    /// <param name="path">A PDS3 image or its label, or any image that GDAL reads.</param>
    /// <param name="given">Properties that the user gives; they count before those that are known.</param>
    /// <param name="bandNanometres">The band that is wanted, nm.</param>
    /// <param name="cacheFolder">The user's cache folder of this program; null if there is none.</param>
    /// <param name="gdalPath">MSISF_GDAL, or null.</param>
    /// <exception cref="BadInputException">The map can't be read, is of another band, or a property of it is not known.</exception>
    /// <exception cref="ExternalPartException">GDAL is needed and missing, or the file system refuses.</exception>
    public static OpenedAlbedoMap Open(string path, MapProperties given, int bandNanometres, string? cacheFolder, string? gdalPath)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException($"{path}: there is no such file. Give a map, or none.");
        }

        PdsMapLabel? label = PdsMapLabel.TryRead(path);
        MapProperties known = label is not null ? KnownMaps.Of(label)
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

        string file = label?.ImagePath ?? path;
        MapLevelsFile levels = MapLevelsFile.Open(
            file, cacheFolder, () => label is not null ? new PdsMapSource(label) : new GdalMapSource(path, gdalPath));
        try
        {
            return new OpenedAlbedoMap(path, Describe(path, levels, properties), levels);
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
        MapExtent extent = (header.Extent, properties.WestDegrees) switch
        {
            (null, null) => throw Unknown(path, "left edge (west)"),
            (null, double west) => WholeMoon(path, header, west),
            ({ } own, null) => own,
            ({ } own, double west) => own with { West = double.DegreesToRadians(west) },
        };
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
