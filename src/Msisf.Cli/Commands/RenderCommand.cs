using System.CommandLine;
using System.CommandLine.Help;
using Msisf.App.Host;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Cli.Pieces;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary>The program's main job, and the root of the command line.</summary>
internal static class RenderCommand
{
    private const string About =
        "Draws synthetic images of the Moon from LOLA elevation data, with the surface point and the direction of the light of their "
            + "pixels.";

    /// <summary>Declares the command and its options.</summary>
    public static RootCommand Create(ProgramHost host)
    {
        RenderOptions options = new();
        RootCommand command = new(About);
        foreach (Option option in options.All)
        {
            command.Options.Add(option);
        }

        // -h is the image's height (thesis appendix A).
        HelpOption help = command.Options.OfType<HelpOption>().Single();
        help.Aliases.Remove("-h");
        help.Aliases.Remove("/h");
        command.SetAction((line, cancellation) => RunAsync(line, options, host, cancellation));
        return command;
    }

    private static async Task<int> RunAsync(ParseResult line, RenderOptions options, ProgramHost host, CancellationToken cancellation)
    {
        (Mode? mode, RenderSettings settings) = options.Read(line);
        if (mode is null)
        {
            new HelpAction().Invoke(line);
            return line.Tokens.Count == 0
                ? 0
                : throw new UsageException($"nothing says where the camera is. Give exactly one of {ModeRules.ModeNames(options.Mode)}.");
        }

        using RenderRun rendering = new(settings, host);
        StateSource states = new(options.Mode, line, rendering.Ephemeris, host.StandardInput, host.Log);
        await rendering.RunAsync(() => states.Read(mode.Value, cancellation), cancellation).ConfigureAwait(false);
        return 0;
    }
}
