using Msisf.Adapters.Raster.Heights;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Lod;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>Finds and opens elevation models.</summary>
internal static class ModelOpening
{
    /// <summary>m, rms: the accuracy of LOLA's heights along a track; models that agree as well are said to meet.</summary>
    private const double MisfitWorthANote = 5.0;

    /// <summary>Finds and opens the model of a resolution.</summary>
    /// <param name="explicitPath">The user's <c>--ldem</c>, or null to look in ./input/ldem and in the installation.</param>
    /// <param name="resolution">The resolution; that of a polar map if the path is one.</param>
    /// <param name="isSparing">Use less memory at the cost of time: POV-Ray needs much memory, and the program waits for it anyway.</param>
    /// <param name="body">The body of which it must be; null for the Moon.</param>
    public static ElevationModel Open(
        string? explicitPath, GridResolution resolution, bool isSparing, ProgramHost host, CelestialBody? body = null,
        CancellationToken cancellation = default)
    {
        if (explicitPath is not null)
        {
            ModelPath model = ModelPath.Parse(explicitPath);
            return MovedModel.Of(model, RasterFiles.IsForGdal(model.Path)
                ? OpenRaster(model, host, cancellation)
                : OpenLdem(model.Path, resolution, isSparing, host, body));
        }

        return OpenLdem(explicitPath, resolution, isSparing, host, body);
    }

    private static ElevationModel OpenLdem(
        string? explicitPath, GridResolution resolution, bool isSparing, ProgramHost host, CelestialBody? body)
    {
        if (resolution.PixelsPerDegree is not { } pixelsPerDegree)
        {
            return OpenMap(explicitPath!, host);
        }

        LdemSet set = SurfaceOptions.Resolution.NamedInErrors(() => SurfaceOptions.Ldem.NamedInErrors(
            () => LdemCatalog.Find(pixelsPerDegree, explicitPath, Folders(host), body: body)));
        if (!set.IsWholeMoon)
        {
            LdemMapImage band = SurfaceOptions.Ldem.NamedInErrors(() => LdemMapImage.Open(set));
            Tell(set, host.Log);
            string longitudes = band.Window.Samples == band.Samples
                ? string.Empty
                : Invariant($" and longitudes {set.Parts[0].WestDegrees:R} to {set.Parts[0].EastDegrees:R}");
            host.Log.Note(Invariant(
                $"It covers latitudes {set.Parts.Min(part => part.SouthDegrees):R} to {set.Parts.Max(part => part.NorthDegrees):R}")
                    + $"{longitudes} degrees; beyond them there is no ground.");
            return MapOf(band, set, host);
        }

        LdemImage image = SurfaceOptions.Resolution.NamedInErrors(() => SurfaceOptions.Ldem.NamedInErrors(() => LdemImage.Open(set)));
        Tell(set, host.Log);
        return image.HasGaps
            ? MapOf(LdemMapImage.Of(image), set, host)
            : new ElevationModel(image, set, image, () => OpenLevels(image, isSparing, host));
    }

    private static ElevationModel MapOf(LdemMapImage map, LdemSet set, ProgramHost host)
    {
        if (map.NoteOfGaps() is { } gaps)
        {
            host.Log.Note(gaps);
        }

        return new ElevationModel(map, set, map);
    }

    /// <summary>Opens several models that make one surface.</summary>
    /// <param name="paths">Labels or images.</param>
    /// <param name="hasLevels">Whether frames are drawn at levels of detail; without them all frames need the models themselves.</param>
    /// <exception cref="MsisfException">A model can't be opened, or they don't fit together.</exception>
    public static ElevationModel OpenSeveral(
        IReadOnlyList<string> paths, bool hasLevels, ProgramHost host, CancellationToken cancellation = default)
    {
        List<ElevationModel> opened = [];
        try
        {
            foreach (string path in paths)
            {
                string file = ModelPath.Parse(path).Path;
                GridResolution resolution = RasterFiles.IsForGdal(file) || LdemCatalog.TryReadMap(file) is not { Polar: { } polar }
                    ? LdemResolutionOf(file)
                    : polar.Resolution;
                opened.Add(Open(path, resolution, isSparing: false, host, cancellation: cancellation));
            }

            return SurfaceOptions.Ldem.NamedInErrors(() =>
            {
                UnitAgainstModel.Check(opened);
                MovedModel.MeetBorders(opened, paths, host.Log);
                SeamFiles files = new([.. opened.Select(model => model.Set)], host.CacheFolder, host.Log.Warning);
                NestedTerrain nested = new(opened.Select(model => (ITerrainGrid)model.Grid), new SeamMemory(files));
                nested.Prepare(hasLevels);
                BorderMisfit?[] misfits = [.. nested.BorderMisfits()];
                TellMisfits(misfits.OfType<BorderMisfit>(), host.Log);
                if (!nested.IsWholeBody)
                {
                    host.Log.Note("No model is of the whole Moon: around the maps there is no ground.");
                }

                return new ElevationModel(
                    nested, misfits, [.. nested.Models.Select(grid => opened.Single(model => ReferenceEquals(model.Grid, grid)))]);
            });
        }
        catch
        {
            opened.ForEach(model => model.Dispose());
            throw;
        }
    }

    /// <summary>Whether <see cref="Open"/> finds a model of a resolution if no path is given.</summary>
    /// <exception cref="BadInputException">There is one, but its parts don't make up a whole Moon.</exception>
    public static bool IsThere(int pixelsPerDegree, ProgramHost host) =>
        SurfaceOptions.Resolution.NamedInErrors(() => LdemCatalog.TryFind(pixelsPerDegree, explicitPath: null, Folders(host))) is not null;

    /// <summary>Folders in which models are searched if no path is given, in the order of the search.</summary>
    public static IReadOnlyList<string> Folders(ProgramHost host) => new DataFolders(DataFolders.Ldem, host).Searched;

    /// <summary>Resolution of a cylindrical label; of a raster that GDAL reads, which knows its own, any.</summary>
    private static GridResolution LdemResolutionOf(string path) => RasterFiles.IsForGdal(path)
        ? 1
        : SurfaceOptions.Ldem.NamedInErrors(() => LdemCatalog.Read(path).PixelsPerDegree);

    private static ElevationModel OpenMap(string path, ProgramHost host) => SurfaceOptions.Ldem.NamedInErrors(() =>
    {
        LdemLabel label = LdemCatalog.TryReadMap(path)
            ?? throw new BadInputException($"{path}: was a polar map when the options were read, and is none any more.");
        LdemSet set = LdemSet.OfMap(label);
        LdemMapImage image = LdemMapImage.Open(set);
        Tell(set, host.Log);
        return MapOf(image, set, host);
    });

    private static ElevationModel OpenRaster(
        ModelPath model, ProgramHost host, CancellationToken cancellation) => SurfaceOptions.Ldem.NamedInErrors(() =>
    {
        GeoTiffGrid grid = host.GeoTiffs.Open(model.Path, model.Heights);
        LdemSet set = LdemSet.OfMap(grid.ToLabel());
        Tell(set, host.Log);
        if (grid.WarpedFrom is not null)
        {
            host.Log.Note(
                $"Its projection ({grid.WarpedFrom}) is warped to {grid.Projection.Resolution}: heights are bilinear between its pixels.");
        }

        if (grid.Prepare(host.CacheFolder, () => Display(grid.ProductId, host), cancellation) is { } warning)
        {
            host.Log.Warning(warning);
        }

        if (grid.Bands > 1)
        {
            host.Log.Note($"It has {grid.Bands} bands; heights are those of the first one.");
        }

        if (grid.NoteOfGaps() is { } gaps)
        {
            host.Log.Note(gaps);
        }

        return grid.AsWholeMoon() is { } moon
            ? new ElevationModel(moon, set, grid, () => ModelLevels.Of(moon))
            : new ElevationModel(grid, set, grid);
    });

    /// <summary>A large raster is looked at once.</summary>
    private static FractionDisplay Display(string productId, ProgramHost host)
    {
        host.Log.Note($"All pixels of {productId} are looked at once, which takes a while; the next runs know them.");
        IRunProgress progress = host.Progress.Start(productId, FractionProgress.Steps, unattended: false);
        return new FractionDisplay(new FractionProgress(progress, productId), progress);
    }

    private static void Tell(LdemSet set, ILog log)
    {
        log.Note(set.IsSynthetic
            ? $"Elevation: {set.ProductId}, a SYNTHETIC model, not the real {set.Body.Name} ({set.Description})."
            : $"Elevation: {set.ProductId} ({set.Description}).");
        if (set.Parts[0].Offset != set.ReferenceRadius)
        {
            log.Note(Invariant(
                $"Its heights are over a sphere of {set.Parts[0].Offset / 1000.0:R} km; they are turned into heights over "
                    + $"{MoonConstants.ReferenceRadius / 1000.0:R} km."));
        }
    }

    /// <summary>Says of each border how well the models meet there.</summary>
    private static void TellMisfits(IEnumerable<BorderMisfit> misfits, ILog log)
    {
        foreach (BorderMisfit misfit in misfits)
        {
            (MisfitNumbers height, MisfitNumbers slope) = (misfit.Height, misfit.Slope);
            string numbers = Invariant(
                $"along its border it lies {Off(height.Mean)} it in the mean ({height.Rms:F1} m rms), at most {Off(height.Greatest)}, and "
                    + $"rises inwards {Degrees(slope.Mean):F1} degrees more steeply ({Degrees(slope.Rms):F1} rms, at most "
                    + $"{Degrees(slope.Greatest):F1}).");
            string remedy = Invariant(
                $"The difference is carried into that ground over {misfit.BlendedMetres / 1000.0:F1} km and more.");
            log.Note(height.Rms <= MisfitWorthANote
                ? $"{misfit.ProductId} meets the ground of the models around it: {numbers}"
                : $"{misfit.ProductId} does not meet the ground of the models around it: {numbers} {remedy}");
        }

        static string Off(double metres) =>
            Invariant($"{Math.Abs(metres):F1} m {(metres < 0.0 ? "below" : "above")}");

        static double Degrees(double tangent) => double.RadiansToDegrees(Math.Atan(tangent));
    }

    private static ModelLevels OpenLevels(LdemImage image, bool isSparing, ProgramHost host)
    {
        ModelLevels levels = ModelLevels.Open(
            image,
            host.CacheFolder,
            samplesBetweenReleases: isSparing ? LodLevels.SparingSamplesBetweenReleases : LodLevels.DefaultSamplesBetweenReleases);
        if (levels.Warning is not null)
        {
            host.Log.Warning(levels.Warning);
        }

        return levels;
    }
}
