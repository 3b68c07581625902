using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Reads which body is drawn, and refuses what is known of the Moon only.</summary>
internal static class BodyChoice
{
    /// <summary>Refuses a raster that GDAL reads, before it is opened: such rasters are read of the Moon only.</summary>
    /// <exception cref="UsageException">One is given for another body.</exception>
    public static void CheckModel(OptionValues values)
    {
        CelestialBody body = CelestialBody.Of(SurfaceOptions.Body.Read(values));
        string? raster = body.IsMoon
            ? null
            : SurfaceOptions.Ldem.ReadAll(values).FirstOrDefault(path => RasterFiles.IsForGdal(ModelPath.Parse(path).Path));
        if (raster is not null)
        {
            throw SurfaceOptions.Body.Wrong(
                $"{body.Name.ToLowerInvariant()} can't be drawn from {raster}: rasters that GDAL reads are of the Moon only. Give a PDS3 "
                    + $"model whose label has TARGET_NAME = {body.CapitalName}, as docs/elevation-models.md describes.",
                SurfaceOptions.Ldem);
        }
    }

    /// <param name="resolution">The resolution of the elevation model.</param>
    /// <exception cref="UsageException">Another option has no meaning with the body.</exception>
    public static CelestialBody Read(OptionValues values, RendererKind renderer, GridResolution resolution)
    {
        CelestialBody body = CelestialBody.Of(SurfaceOptions.Body.Read(values));
        if (body.IsMoon)
        {
            return body;
        }

        OptionSpec[] orbits = [CameraOptions.KeplerSet, CameraOptions.StateVectors];
        OptionSpec[] maps = [AlbedoOptions.Map, NativeOptions.HapkeMap];
        (string Why, OptionSpec Other)? refused =
            renderer != RendererKind.Native
                ? ("needs --renderer native: POV-Ray's patterns are those of the Moon.", RendererOptions.Renderer)
            : !values.IsGiven(SurfaceOptions.Ldem)
                ? ($"needs {SurfaceOptions.Ldem.Name} with the label of a model of {body.Name}.", SurfaceOptions.Ldem)
            : SurfaceOptions.Ldem.ReadAll(values).Count > 1
                ? ($"is drawn from one model; several {SurfaceOptions.Ldem.Name} are of the Moon only.", SurfaceOptions.Ldem)
            : resolution.PixelsPerDegree is null
                ? ("needs a model of latitude and longitude: other maps are read of the Moon only.", SurfaceOptions.Ldem)
            : orbits.FirstOrDefault(values.IsGiven) is { } orbit
                ? ($"can't be combined with {orbit.Name}: orbits are computed with the Moon's gravity. Give positions.", orbit)
            : values.IsGiven(NativeOptions.Refine)
                ? ($"can't be combined with {NativeOptions.Refine.Name}: what it invents is the Moon's. Leave it out.",
                    NativeOptions.Refine)
            : maps.FirstOrDefault(option => values.Text(option) is { } text && text != AlbedoOptions.NoMap) is { } map
                ? ($"can't be combined with {map.Name}: the known maps are those of the Moon. Leave it out.", map)
            : null;
        return refused is ({ } why, { } other)
            ? throw SurfaceOptions.Body.Wrong($"{body.Name.ToLowerInvariant()} {why}", other)
            : body;
    }
}
