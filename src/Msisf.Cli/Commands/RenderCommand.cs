using System.CommandLine;
using System.CommandLine.Help;
using Msisf.Cli.Options;
using Msisf.Cli.Run;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary>The program's main job, and the root of the command line.</summary>
internal static class RenderCommand
{
    private const string About =
        "Draws synthetic pictures of the Moon from LOLA elevation data, with the surface point and the direction of the light of their pixels.";

    /// <summary>Declares the command and its options.</summary>
    public static RootCommand Create(ProgramHost host)
    {
        ModeOptions mode = new();
        PictureOptions picture = new();
        SourceOptions source = new();
        RunOptions run = new();
        NativeOptions native = new();
        RootCommand command = new(About);
        foreach (Option option in (Option[])[.. mode.All, .. picture.All, .. source.All, .. native.All, .. run.All])
        {
            command.Options.Add(option);
        }

        // -h is the picture's height (thesis appendix A).
        HelpOption help = command.Options.OfType<HelpOption>().Single();
        help.Aliases.Remove("-h");
        help.Aliases.Remove("/h");
        command.SetAction((line, cancellation) => RunAsync(line, mode, picture, source, run, native, host, cancellation));
        return command;
    }

    private static async Task<int> RunAsync(
        ParseResult line,
        ModeOptions modeOptions,
        PictureOptions picture,
        SourceOptions source,
        RunOptions run,
        NativeOptions native,
        ProgramHost host,
        CancellationToken cancellation)
    {
        StrayOptions.Refuse(line, run.PovOptions);
        bool IsGiven(Option option) => line.GetResult(option) is { Implicit: false };
        if (ModeRules.Check(modeOptions, IsGiven) is not Mode mode)
        {
            new HelpAction().Invoke(line);
            return line.Tokens.Count == 0
                ? 0
                : throw new UsageException($"nothing says where the camera is. Give exactly one of {ModeRules.ModeNames(modeOptions)}.");
        }

        RenderSettings settings = new RenderSettingsReader(line).Read(picture, source, run, native);
        RendererRules.Check(settings.Renderer, native, source, run, IsGiven);
        using RenderRun rendering = new(settings, host);
        StateSource states = new(modeOptions, line, rendering.Ephemeris, host.StandardInput, host.Log);
        await rendering.RunAsync(() => states.Read(mode, cancellation), cancellation).ConfigureAwait(false);
        return 0;
    }
}
