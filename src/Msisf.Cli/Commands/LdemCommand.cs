using System.CommandLine;
using System.Globalization;
using Msisf.Adapters.Synthesis;
using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Cli.Commands;

/// <summary>Work on elevation models: <c>msis ldem synthesize</c>, <c>msis ldem pyramid</c>.</summary>
internal static class LdemCommand
{
    /// <summary>Declares the command, its subcommands and their options.</summary>
    public static Command Create(ProgramHost host)
    {
        Command command = new("ldem", "Works on elevation models.");
        command.Subcommands.Add(CreateSynthesize(host));
        command.Subcommands.Add(PyramidCommand.Create(host));
        return command;
    }

    private static Command CreateSynthesize(ProgramHost host)
    {
        Option<string?> resolution = OptionFactory.Value("--res", ["-r"], "RESOLUTION", "Resolution of the new model in px/deg");
        Option<string?> baseModel = OptionFactory.Value(
            "--base", [], "FILE", "Model that the new one continues downwards: its label or image (default: none, an invented Moon)");
        Option<string?> region = OptionFactory.Value(
            "--region", [], "latmin:latmax:lonmin:lonmax", "Part of the Moon in whole degrees (default: all of it)");
        Option<string?> seed = OptionFactory.Value(
            "--seed", [], "N", "Number that the terrain is drawn from; the same number, the same bytes");
        Option<string?> folder = OptionFactory.Value("--output-dir", ["-o"], "PATH", "Folder of the new model (default ./input/ldem)");
        Option<bool> batch = OptionFactory.Flag("--batch", ["-b"], "Unattended: draw no progress bar");
        resolution.Required = true;
        seed.Required = true;
        Command command = new("synthesize", "Writes a synthetic elevation model, with craters and roughness like the Moon's.")
        {
            resolution, baseModel, region, seed, folder, batch,
        };
        command.SetAction((line, cancellation) => Task.Run(
            () =>
            {
                StrayOptions.Refuse(line);
                using LdemImage? continued = line.GetValue(baseModel) is string path
                    ? LdemImage.Open(LdemCatalog.Read(OptionText.FilePath(baseModel, path)))
                    : null;
                SyntheticLdemOptions options = new(
                    OptionText.WholeNumber(resolution, line.GetValue(resolution)!, 1, SourceSettings.FinestResolution),
                    Seed(seed, line.GetValue(seed)!),
                    line.GetValue(folder) is string given ? OptionText.FilePath(folder, given) : Path.Combine("input", "ldem"))
                {
                    Base = continued,
                    Region = line.GetValue(region) is string text ? Region(text) : MoonRegion.WholeMoon,
                };
                using IRunProgress progress = host.Progress.Start("Synthesis", FractionProgress.Steps, line.GetValue(batch));
                string label = SyntheticLdemWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation);
                host.Results.WriteLine(label);
                return 0;
            },
            cancellation));
        return command;
    }

    private static ulong Seed(Option option, string text) =>
        ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
            ? seed
            : throw new BadInputException($"{option.Name} is '{text}'; a whole number from 0 to {ulong.MaxValue} is needed.");

    private static MoonRegion Region(string text)
    {
        try
        {
            return MoonRegion.Parse(text);
        }
        catch (UsageException exception)
        {
            throw new BadInputException(exception.Message, exception); // it names the option
        }
    }
}
