using Msisf.Adapters.Raster;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>
/// Makes or checks the sidecar file of an elevation model that holds its coarser levels; of a map that GDAL reads, what was found by
/// looking at all its pixels.
/// </summary>
internal static class ModelPyramid
{
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>Path of the file; null if the model needs none, which is logged.</returns>
    /// <exception cref="MsisfException">There is no such model, or the file can't be written.</exception>
    public static string? Make(PyramidSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        if (TryOpenMap(settings, host) is { } opened)
        {
            using GeoTiffGrid map = opened;
            return MakeOfMap(map, settings, host, cancellation);
        }

        using LdemImage image = LdemImage.Open(Find(settings, host));
        SidecarPlaces places = ModelLevels.PlacesOf(image.Set, host.CacheFolder);
        string path = places.ForWriting();
        if (path != places.Beside)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            host.Log.Note($"The folder of {places.Beside} can't be written to; the pyramid goes to {path}.");
        }

        using IRunProgress progress = host.Progress.Start("Pyramid", FractionProgress.Steps, settings.Unattended);
        PyramidWriter.Write(image, path, Environment.ProcessorCount, new FractionProgress(progress, "pyramid"), cancellation);
        RememberChecksums(image.Set, host, cancellation);
        return path;
    }

    /// <summary>Checks the file against the model by reading both.</summary>
    /// <returns>Path of the file; null if the model needs none, which is logged.</returns>
    /// <exception cref="MsisfException">There is no such model or no such file, or they differ.</exception>
    public static string? Verify(PyramidSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        if (TryOpenMap(settings, host) is { } opened)
        {
            using GeoTiffGrid map = opened;
            return VerifyOfMap(map, host, cancellation);
        }

        using LdemImage image = LdemImage.Open(Find(settings, host));
        using ModelLevels levels = ModelLevels.Open(image, host.CacheFolder);
        if (levels.Sidecar is not { } sidecar)
        {
            throw new BadInputException(
                levels.Warning
                    ?? $"{ModelLevels.PlacesOf(image.Set, host.CacheFolder).Beside}: missing. Make it with 'msis ldem pyramid'.");
        }

        sidecar.Verify(image, cancellation);
        host.Log.Note($"{sidecar.FilePath} is whole, and made of the samples that {image.ProductId} has.");
        return sidecar.FilePath;
    }

    /// <summary>The first run would read the whole model once more for them.</summary>
    private static void RememberChecksums(LdemSet set, ProgramHost host, CancellationToken cancellation)
    {
        if (LdemChecksums.Open(set, host.CacheFolder).Read(cancellation).Warning is { } warning)
        {
            host.Log.Warning(warning);
        }
    }

    /// <summary>The map that is named, if GDAL reads it.</summary>
    private static GeoTiffGrid? TryOpenMap(PyramidSettings settings, ProgramHost host)
    {
        if (settings.Model is not { } text || !RasterFiles.IsForGdal(ModelPath.Parse(text).Path))
        {
            return null;
        }

        ModelPath model = ModelPath.Parse(text);
        return settings.PixelsPerDegree is null
            ? host.GeoTiffs.Open(model.Path, model.Heights)
            : throw ModelOptions.ModelResolution.Wrong($"is for a folder of models; {model.Path} has its own. Leave it out.");
    }

    private static string? MakeOfMap(GeoTiffGrid map, PyramidSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        if (!IsLarge(map, host))
        {
            return null;
        }

        FractionDisplay Display()
        {
            IRunProgress progress = host.Progress.Start(map.ProductId, FractionProgress.Steps, settings.Unattended);
            return new FractionDisplay(new FractionProgress(progress, map.ProductId), progress);
        }

        if (map.Prepare(host.CacheFolder, Display, cancellation) is { } failure)
        {
            throw new ExternalPartException(failure);
        }

        RememberChecksums(LdemSet.OfMap(map.ToLabel()), host, cancellation);
        return map.FindKept(host.CacheFolder);
    }

    private static string? VerifyOfMap(GeoTiffGrid map, ProgramHost host, CancellationToken cancellation)
    {
        if (!IsLarge(map, host))
        {
            return null;
        }

        string path = map.VerifyKept(host.CacheFolder, cancellation)
            ?? throw new BadInputException(
                $"{map.Files[0]}: no file beside it holds what its pixels are. Make it with 'msis ldem pyramid'.");
        host.Log.Note($"{path} is whole, and made of the pixels that {map.ProductId} has.");
        return path;
    }

    private static bool IsLarge(GeoTiffGrid map, ProgramHost host)
    {
        if (!map.IsLarge)
        {
            host.Log.Note($"{map.ProductId} is so small that each run looks at all its pixels; it needs no file.");
        }

        return map.IsLarge;
    }

    private static LdemSet Find(PyramidSettings settings, ProgramHost host)
    {
        string? path = settings.Model;
        if (path is not null && path.Trim().Length == 0)
        {
            throw new UsageException("The model's name is empty; the path of its label or its folder is needed.");
        }

        if (settings.PixelsPerDegree is { } pixelsPerDegree)
        {
            return LdemCatalog.Find(
                pixelsPerDegree, path, ModelOpening.Folders(host), "give the label of another one instead of --res");
        }

        if (path is not null && !Directory.Exists(path) && LdemCatalog.TryReadMap(path) is not null)
        {
            throw new BadInputException(
                $"{path}: a polar map in PDS3 needs no pyramid, as its levels are computed where they are read. Draw with it as it is.");
        }

        return path is not null && !Directory.Exists(path)
            ? LdemCatalog.ReadOfAnyBody(path)
            : throw new UsageException("pyramid needs a model: give its label, or --res to say which one of a folder.");
    }
}

/// <summary>Writes a synthetic elevation model.</summary>
internal static class SyntheticModel
{
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>Path of the model's label.</returns>
    /// <exception cref="MsisfException">The base model is not suitable, or the folder can't be written.</exception>
    public static string Write(SynthesisSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using ElevationModel? baseModel = settings.BaseModel is { } path ? OpenBase(path, host, cancellation) : null;
        IGlobalGrid? continued = baseModel?.WholeMoon;
        if (settings.Map is { } map)
        {
            return WriteMap(map, settings, continued, host, cancellation);
        }

        SyntheticLdemOptions options = new(settings.PixelsPerDegree, settings.Seed, settings.Folder)
        {
            Body = settings.Body,
            Base = continued,
            Region = settings.Region,
            Rest = settings.Rest,
            Format = settings.SampleType is { } type
                ? new SyntheticSampleFormat(type)
                : SyntheticLdemOptions.DefaultFormat(settings.PixelsPerDegree),
        };
        using IRunProgress progress = host.Progress.Start("Synthesis", FractionProgress.Steps, settings.Unattended);
        return SyntheticLdemWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation);
    }

    private static ElevationModel OpenBase(string path, ProgramHost host, CancellationToken cancellation) => ModelOpening.Open(
        path, RasterFiles.IsForGdal(ModelPath.Parse(path).Path) ? 1 : LdemCatalog.Read(path).PixelsPerDegree, isSparing: false, host,
        cancellation: cancellation);

    private static string WriteMap(
        SyntheticMapSettings map, SynthesisSettings settings, IGlobalGrid? continued, ProgramHost host, CancellationToken cancellation)
    {
        SyntheticMapOptions options = new(map.IsSouth, map.MetresPerPixel, map.LatitudeDegrees, settings.Seed, settings.Folder)
        {
            Base = continued,
            Format = new SyntheticSampleFormat(settings.SampleType ?? LdemSampleType.Float32LittleEndian),
        };
        using IRunProgress progress = host.Progress.Start("Synthesis", FractionProgress.Steps, settings.Unattended);
        return ModelOptions.Latitude.NamedInErrors(
            () => SyntheticMapWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation));
    }
}
