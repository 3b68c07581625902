using Msisf.Adapters.Lod;
using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary><c>msis ldem pyramid</c>: makes or checks the sidecar with a model's levels of detail.</summary>
internal static class PyramidCommand
{
    /// <summary>Does it.</summary>
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        using LdemImage image = LdemImage.Open(Find(call.Values.Argument, ModelOptions.ModelResolution.ReadIfGiven(call.Values), call.Host));
        PyramidPlaces places = PyramidPlaces.Of(image.Set, CacheFolder.Of(call.Host));
        call.Host.Results.WriteLine(ModelOptions.Verify.Read(call.Values)
            ? Verify(image, places, call.Host, cancellation)
            : Make(image, places, RunOptions.Batch.Read(call.Values), call.Host, cancellation));
        return 0;
    }

    private static LdemSet Find(string? path, int? resolution, ProgramHost host)
    {
        if (path is not null && path.Trim().Length == 0)
        {
            throw new BadInputException("The model's name is empty; the path of its label or its folder is needed.");
        }

        if (resolution is { } pixelsPerDegree)
        {
            return LdemCatalog.Find(pixelsPerDegree, path, ElevationModel.Folders(host));
        }

        return path is not null && !Directory.Exists(path)
            ? LdemCatalog.Read(path)
            : throw new UsageException("pyramid needs a model: give its label, or --res to say which one of a folder.");
    }

    private static string Make(LdemImage image, PyramidPlaces places, bool unattended, ProgramHost host, CancellationToken cancellation)
    {
        string path = places.ForWriting();
        if (path != places.Beside)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            host.Log.Note($"The folder of {places.Beside} can't be written to; the pyramid goes to {path}.");
        }

        using IRunProgress progress = host.Progress.Start("Pyramid", FractionProgress.Steps, unattended);
        PyramidWriter.Write(image, path, Environment.ProcessorCount, new FractionProgress(progress, "pyramid"), cancellation);
        return path;
    }

    private static string Verify(LdemImage image, PyramidPlaces places, ProgramHost host, CancellationToken cancellation)
    {
        using ModelLevels levels = ModelLevels.Open(image, CacheFolder.Of(host));
        if (levels.Sidecar is not { } sidecar)
        {
            throw new BadInputException(levels.Warning ?? $"{places.Beside}: missing. Make it with 'msis ldem pyramid'.");
        }

        sidecar.Verify(image, cancellation);
        host.Log.Note($"{sidecar.FilePath} is whole, and made of the samples that {image.ProductId} has.");
        return sidecar.FilePath;
    }
}
