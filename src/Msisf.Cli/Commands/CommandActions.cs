using Msisf.App.DataSets;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.App.Settings.Config;
using Msisf.App.Settings.Specs;
using Msisf.App.States;
using Msisf.App.Twins;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Fetching;
using Msisf.Adapters.Input;
using Msisf.Cli.Completion;
using Msisf.Cli.Help;

namespace Msisf.Cli.Commands;

/// <summary>The actions of the commands in the table.</summary>
internal static class CommandActions
{
    private static readonly Dictionary<CommandSpec, CommandAction> Actions = new(ReferenceEqualityComparer.Instance)
    {
        [CommandTable.Render] = RunCommands.RenderAsync,
        [CommandTable.Patterns] = RunCommands.MakePatternsAsync,
        [CommandTable.BatchConvert] = InBackground(SeriesCommands.Convert),
        [CommandTable.Submit] = InBackground(SeriesCommands.SubmitAsync),
        [CommandTable.States] = InBackground(RunCommands.WriteStates),
        [CameraModelOptions.Command] = Printing(call => CameraModelExport.Write(call.Values, call.Host)),
        [TwinOptions.Command] = InBackground(async (call, cancellation) =>
        {
            await TwinRun.RunAsync(call.Values, call.Host, cancellation).ConfigureAwait(false);
            return 0;
        }),
        [DataSetOptions.Command] = InBackground((call, cancellation) =>
            DataSetRun.RunAsync(call.Values.Argument!, call.Values, call.Words, call.Host, cancellation)),
        [IlluminationOptions.Command] = InBackground(RunCommands.Illuminate),
        [CommandTable.Status] = InBackground(SeriesCommands.Status),
        [CommandTable.Verify] = InBackground(SeriesCommands.Verify),
        [CommandTable.Merge] = InBackground(SeriesCommands.MergeAsync),
        [FetchOptions.Ldem] = InBackground((call, cancellation) => DataFetch.LdemAsync(call.Values, call.Host, cancellation)),
        [FetchOptions.Albedo] = InBackground((call, cancellation) => DataFetch.AlbedoAsync(call.Values, call.Host, cancellation)),
        [FetchOptions.Stars] = InBackground((call, cancellation) =>
            PublicFileFetch.GetAsync([PublicFile.Hipparcos], DataFolders.Stars, call.Values, call.Host, cancellation)),
        [FetchOptions.Kernels] = InBackground((call, cancellation) =>
            PublicFileFetch.GetAsync(PublicFile.Kernels, DataFolders.Kernels, call.Values, call.Host, cancellation)),
        [CommandTable.Synthesize] = InBackground(Synthesize),
        [CommandTable.Pyramid] = InBackground(MakePyramid),
        [CommandTable.View] = ViewAsync,
        [CommandTable.Serve] = (call, cancellation) => ServerProgram.RunAsync(call.Values, call.Host, cancellation),
        [CommandTable.ConfigShow] = Printing(call => Configuration.Show(call.Values.Text(RunOptions.Config), call.Host)),
        [CommandTable.Cameras] = Printing(PrintCameras),
        [CommandTable.Kernels] = Printing(KernelsCommand.Print),
        [CommandTable.Places] = Printing(PlacesCommand.Print),
        [CommandTable.Completion] = Printing(call => call.Host.Results.Write(CompletionScript.For(call.Values.Argument!))),
        [CommandTable.Help] = Printing(PrintHelp),
        [CommandTable.Man] = Printing(call => call.Host.Results.Write(ManualPage.Text(call.Host.Version))),
    };

    /// <summary>The action of a command without subcommands, or of the program itself.</summary>
    public static CommandAction Of(CommandSpec command) => Actions[command];

    /// <summary>Runs long work on another thread, so that the main thread can react to Ctrl-C.</summary>
    private static CommandAction InBackground(Func<CommandCall, CancellationToken, int> work) =>
        (call, cancellation) => Task.Run(() => work(call, cancellation), cancellation);

    private static CommandAction InBackground(Func<CommandCall, CancellationToken, Task<int>> work) =>
        (call, cancellation) => Task.Run(() => work(call, cancellation), cancellation);

    private static CommandAction Printing(Action<CommandCall> print) => (call, _) =>
    {
        print(call);
        return Task.FromResult(0);
    };

    private static int Synthesize(CommandCall call, CancellationToken cancellation)
    {
        call.Host.Results.WriteLine(SyntheticModel.Write(ModelOptions.ReadSynthesis(call.Values), call.Host, cancellation));
        return 0;
    }

    private static int MakePyramid(CommandCall call, CancellationToken cancellation)
    {
        PyramidSettings settings = ModelOptions.ReadPyramid(call.Values);
        string? path = ModelOptions.Verify.Read(call.Values)
            ? ModelPyramid.Verify(settings, call.Host, cancellation)
            : ModelPyramid.Make(settings, call.Host, cancellation);
        if (path is not null)
        {
            call.Host.Results.WriteLine(path);
        }

        return 0;
    }

    /// <summary>Runs a server until a signal ends it, and opens its page in the browser.</summary>
    private static Task<int> ViewAsync(CommandCall call, CancellationToken cancellation)
    {
        Browser browser = new(call.Host);
        return ServerProgram.RunAsync(
            ViewOptions.OfServer(call.Values),
            call.Host,
            cancellation,
            address =>
            {
                call.Host.Results.WriteLine(address);
                call.Host.Results.Flush();
                if (!ViewOptions.NoBrowser.Read(call.Values))
                {
                    browser.Open(address);
                }
            });
    }

    /// <summary>Lists the presets of <c>--camera</c>.</summary>
    private static void PrintCameras(CommandCall call)
    {
        foreach (CameraFile camera in CameraChoice.Presets(call.Host.Installation))
        {
            call.Host.Results.WriteLine(Invariant(
                $"{camera.Name}\t{camera.Model.Width}\t{camera.Model.Height}\t{camera.FieldOfViewDegrees:G6}\t{camera.Description}"));
        }
    }

    private static void PrintHelp(CommandCall call)
    {
        string[] words = (call.Values.Argument ?? string.Empty).Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words is [var topic] && ShortHelp.Topics.ContainsKey(topic))
        {
            HelpText.WriteTopic(call.Host.Results, topic);
            return;
        }

        bool isAll = words is [.., ShortHelp.All];
        string[] called = isAll ? words[..^1] : words;
        string path = string.Join(' ', called);
        string[] names =
        [
            .. CommandTable.All.Where(entry => entry.Path.Length > 0).Select(entry => entry.Command.Name), .. ShortHelp.Topics.Keys,
        ];
        CommandSpec command = HelpWords.Find(called) ?? throw new UsageException(
            $"'{path}' is neither a command nor a topic{NearestName.Question(path.Split(' ')[^1], names, ".")} msis help lists them.");
        if (isAll)
        {
            HelpText.WriteAll(call.Host.Results, path, command);
        }
        else
        {
            HelpText.Write(call.Host.Results, path, command);
        }
    }
}

/// <summary>The action of a command.</summary>
/// <param name="call">Options of the call.</param>
/// <returns>The exit code.</returns>
internal delegate Task<int> CommandAction(CommandCall call, CancellationToken cancellation);

/// <summary>One call of a command.</summary>
/// <param name="Values">Options of the call, including those from configuration files.</param>
/// <param name="Words">All words of the command line, with the words of response files inserted in their places.</param>
internal sealed record CommandCall(OptionValues Values, IReadOnlyList<string> Words, ProgramHost Host);
