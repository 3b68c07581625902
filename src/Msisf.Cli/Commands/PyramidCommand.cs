using System.CommandLine;
using Msisf.Adapters.Lod;
using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary>Makes or checks the sidecar with a model's levels of detail.</summary>
internal static class PyramidCommand
{
    /// <summary>Declares the command, its argument and its options.</summary>
    public static Command Create(ProgramHost host)
    {
        Argument<string?> model = new("model")
        {
            HelpName = "LABEL|FOLDER",
            Description = "The model: its label, its image, or the folder that it lies in with --res (default ./input/ldem)",
            Arity = ArgumentArity.ZeroOrOne,
        };
        Option<string?> resolution = OptionFactory.Value(
            "--res", ["-r"], "RESOLUTION", "Resolution of the model in px/deg; needed for a folder");
        Option<bool> verify = OptionFactory.Flag("--verify", [], "Make nothing; read the model and its pyramid and compare them");
        Option<bool> batch = OptionFactory.Flag("--batch", ["-b"], "Unattended: draw no progress bar");
        Command command = new(
            "pyramid", "Writes a model's coarser levels into a file beside it, so that far views of fine models need not read it all.")
        {
            model, resolution, verify, batch,
        };
        command.SetAction((line, cancellation) => Task.Run(
            () =>
            {
                StrayOptions.Refuse(line);
                int? asked = line.GetValue(resolution) is string text
                    ? OptionText.WholeNumber(resolution, text, 1, SourceSettings.FinestResolution)
                    : null;
                using LdemImage image = LdemImage.Open(Find(line.GetValue(model), asked, host));
                PyramidPlaces places = PyramidPlaces.Of(image.Set, CacheFolder.Of(host));
                host.Results.WriteLine(line.GetValue(verify)
                    ? Verify(image, places, host, cancellation)
                    : Make(image, places, line.GetValue(batch), host, cancellation));
                return 0;
            },
            cancellation));
        return command;
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
