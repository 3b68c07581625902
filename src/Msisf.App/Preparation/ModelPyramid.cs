using Msisf.Adapters.Raster;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Raster.Levels;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.App.Preparation;

/// <summary>Makes or checks the sidecar file of an elevation model that holds its coarser levels.</summary>
internal static class ModelPyramid
{
    /// <summary>Makes the file.</summary>
    /// <param name="settings">Names the model.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>Path of the file.</returns>
    /// <exception cref="MsisfException">There is no such model, or the file can't be written.</exception>
    public static string Make(PyramidSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using LdemImage image = LdemImage.Open(Find(settings, host));
        SidecarPlaces places = ModelLevels.PlacesOf(image.Set, CacheFolder.Of(host));
        string path = places.ForWriting();
        if (path != places.Beside)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            host.Log.Note($"The folder of {places.Beside} can't be written to; the pyramid goes to {path}.");
        }

        using IRunProgress progress = host.Progress.Start("Pyramid", FractionProgress.Steps, settings.Unattended);
        PyramidWriter.Write(image, path, Environment.ProcessorCount, new FractionProgress(progress, "pyramid"), cancellation);
        RememberChecksums(image, host, cancellation);
        return path;
    }

    /// <summary>Checks the file against the model by reading both.</summary>
    /// <param name="settings">Names the model.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <returns>Path of the file.</returns>
    /// <exception cref="MsisfException">There is no such model or no such file, or they differ.</exception>
    public static string Verify(PyramidSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using LdemImage image = LdemImage.Open(Find(settings, host));
        using ModelLevels levels = ModelLevels.Open(image, CacheFolder.Of(host));
        if (levels.Sidecar is not { } sidecar)
        {
            throw new BadInputException(
                levels.Warning
                    ?? $"{ModelLevels.PlacesOf(image.Set, CacheFolder.Of(host)).Beside}: missing. Make it with 'msis ldem pyramid'.");
        }

        sidecar.Verify(image, cancellation);
        host.Log.Note($"{sidecar.FilePath} is whole, and made of the samples that {image.ProductId} has.");
        return sidecar.FilePath;
    }

    /// <summary>The first run would read the whole model once more for them.</summary>
    private static void RememberChecksums(LdemImage image, ProgramHost host, CancellationToken cancellation)
    {
        if (LdemChecksums.Open(image.Set, CacheFolder.Of(host)).Read(cancellation).Warning is { } warning)
        {
            host.Log.Warning(warning);
        }
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

        return path is not null && !Directory.Exists(path)
            ? LdemCatalog.ReadOfAnyBody(path)
            : throw new UsageException("pyramid needs a model: give its label, or --res to say which one of a folder.");
    }
}
