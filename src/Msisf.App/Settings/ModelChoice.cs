using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Reads which elevation model <c>--ldem</c> and <c>--res</c> mean.</summary>
internal static class ModelChoice
{
    /// <summary>The resolution of the run's model: a map of a part has its own.</summary>
    /// <exception cref="UsageException">The options contradict the map that --ldem names.</exception>
    /// <param name="geoTiffs">Opens elevation models in GeoTIFF, and keeps them; null to close them again.</param>
    public static GridResolution ResolutionOf(OptionValues values, GeoTiffFiles? geoTiffs)
    {
        if (geoTiffs is null)
        {
            using GeoTiffFiles closed = new(libraryPath: null);
            return ResolutionOf(values, closed);
        }

        if (SurfaceOptions.Ldem.ReadAll(values) is { Count: > 1 } several)
        {
            return ResolutionOfSeveral(several, values, geoTiffs);
        }

        if (SurfaceOptions.Ldem.ReadIfGiven(values) is { } only && ModelPath.Parse(only).Placement.MeetsBorder)
        {
            throw SurfaceOptions.Ldem.Wrong(
                $"{only}: offset=auto raises a map to meet the models around it, and there are none. Give a model of the whole Moon as "
                    + "well, or metres.");
        }

        if (SurfaceOptions.Ldem.ReadIfGiven(values) is not { } path || ResolutionOfMap(path, geoTiffs) is not { } resolution)
        {
            return CylindricalResolutionOf(values);
        }

        if (SurfaceOptions.Resolution.ReadIfGiven(values) is { } given && given != resolution.PixelsPerDegree)
        {
            throw SurfaceOptions.Resolution.Wrong($"contradicts --ldem {path}, a map of {resolution}. Leave it out.", SurfaceOptions.Ldem);
        }

        return resolution;
    }

    /// <summary>The resolution of a model of latitude and longitude: a label, image or folder that --ldem names says it itself.</summary>
    /// <remarks>A file on the command line goes before a resolution of a configuration file.</remarks>
    public static int CylindricalResolutionOf(OptionValues values)
    {
        string? path = SurfaceOptions.Ldem.ReadIfGiven(values) is { } text ? ModelPath.Parse(text).Path : null;
        if (Directory.Exists(path) && values.Text(SurfaceOptions.Resolution) is null)
        {
            return SurfaceOptions.Ldem.NamedInErrors(() => LdemCatalog.ResolutionIn(
                path!, SurfaceOptions.Resolution.Read(values), CelestialBody.Of(SurfaceOptions.Body.Read(values))));
        }

        bool isFile = File.Exists(path); // a missing one is reported when it is opened
        bool isSaid = values.IsGiven(SurfaceOptions.Resolution)
            || (values.Text(SurfaceOptions.Resolution) is not null && !values.IsGiven(SurfaceOptions.Ldem));
        if (path is not null && RasterFiles.IsForGdal(path))
        {
            using GeoTiffFiles closed = new(libraryPath: null);
            return ResolutionOfMap(SurfaceOptions.Ldem.ReadIfGiven(values)!, closed)?.PixelsPerDegree ?? throw SurfaceOptions.Ldem.Wrong(
                $"{path}: a map around a pole; a model of the whole Moon is needed here.");
        }

        return isFile && !isSaid
            ? SurfaceOptions.Ldem.NamedInErrors(() => LdemCatalog.ResolutionOf(path!))
            : SurfaceOptions.Resolution.Read(values);
    }

    /// <summary>The resolution of the finest of several models.</summary>
    private static GridResolution ResolutionOfSeveral(IReadOnlyList<string> paths, OptionValues values, GeoTiffFiles geoTiffs)
    {
        if (SurfaceOptions.Resolution.ReadIfGiven(values) is not null)
        {
            throw SurfaceOptions.Resolution.Wrong(
                "has no meaning with several --ldem: each model has its own resolution. Leave it out.", SurfaceOptions.Ldem);
        }

        if (paths.GroupBy(path => Path.GetFullPath(ModelPath.Parse(path).Path)).FirstOrDefault(same => same.Count() > 1) is { } twice)
        {
            throw SurfaceOptions.Ldem.Wrong($"{twice.First()} is given twice. Leave one of them out.");
        }

        return paths.Select(path => ResolutionOfMap(path, geoTiffs) ?? ResolutionOfLabel(path)).MinBy(found => found.MetresPerPixel);
    }

    private static GridResolution ResolutionOfLabel(string path) => SurfaceOptions.Ldem.NamedInErrors(() => Directory.Exists(path)
        ? throw new BadInputException($"{path}: a folder; of several --ldem each names the label or the image of a model.")
        : LdemCatalog.Read(ModelPath.Parse(path).Path).PixelsPerDegree);

    private static GridResolution? ResolutionOfMap(string text, GeoTiffFiles geoTiffs)
    {
        ModelPath model = ModelPath.Parse(text);
        return RasterFiles.IsForGdal(model.Path)
            ? SurfaceOptions.Ldem.NamedInErrors(() => geoTiffs.ResolutionOf(model.Path, model.Heights))
            : LdemCatalog.TryReadMap(model.Path)?.Polar?.Resolution;
    }
}
