using Msisf.App.DataSets;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Config;
using Msisf.App.Settings.Specs;
using Msisf.App.States;
using Msisf.App.Twins;
using Msisf.Cli.Completion;
using Msisf.Cli.Help;

namespace Msisf.Cli.Commands;

/// <summary>The actions of the commands in the table.</summary>
internal static class CommandActions
{
    private static readonly Dictionary<CommandSpec, CommandAction> Actions = new(ReferenceEqualityComparer.Instance)
    {
        [CommandTable.Render] = RenderCommand.RunAsync,
        [CommandTable.Patterns] = PatternsCommand.RunAsync,
        [CommandTable.BatchConvert] = InBackground(BatchConvertCommand.Run),
        [CommandTable.Submit] = (call, cancellation) => Task.Run(() => SubmitCommand.RunAsync(call, cancellation), cancellation),
        [CommandTable.States] = InBackground(StatesCommand.Run),
        [CameraModelOptions.Command] = Printing(call => CameraModelExport.Write(call.Values, call.Host)),
        [TwinOptions.Command] = (call, cancellation) => Task.Run(
            async () =>
            {
                await TwinRun.RunAsync(call.Values, call.Host, cancellation).ConfigureAwait(false);
                return 0;
            },
            cancellation),
        [DataSetOptions.Command] = (call, cancellation) => Task.Run(
            () => DataSetRun.RunAsync(call.Values.Argument!, call.Values, call.Words, call.Host, cancellation), cancellation),
        [IlluminationOptions.Command] = InBackground(IlluminationCommand.Run),
        [CommandTable.Status] = InBackground(CheckCommand.Status),
        [CommandTable.Verify] = InBackground(CheckCommand.Verify),
        [CommandTable.Merge] = (call, cancellation) => Task.Run(() => MergeCommand.RunAsync(call, cancellation), cancellation),
        [CommandTable.Synthesize] = InBackground(SynthesizeCommand.Run),
        [CommandTable.Pyramid] = InBackground(PyramidCommand.Run),
        [CommandTable.View] = ViewCommand.RunAsync,
        [CommandTable.Serve] = ServeCommand.RunAsync,
        [CommandTable.ConfigShow] = Printing(call => Configuration.Show(call.Values.Text(RunOptions.Config), call.Host)),
        [CommandTable.Cameras] = Printing(CamerasCommand.Print),
        [CommandTable.Kernels] = Printing(KernelsCommand.Print),
        [CommandTable.Completion] = Printing(call => call.Host.Results.Write(CompletionScript.For(call.Values.Argument!))),
        [CommandTable.Help] = Printing(HelpCommand.Run),
        [CommandTable.Man] = Printing(call => call.Host.Results.Write(ManualPage.Text(call.Host.Version))),
    };

    /// <summary>The action of a command without subcommands, or of the program itself.</summary>
    public static CommandAction Of(CommandSpec command) => Actions[command];

    /// <summary>Runs long work on another thread, so that the main thread can react to Ctrl-C.</summary>
    private static CommandAction InBackground(Func<CommandCall, CancellationToken, int> work) =>
        (call, cancellation) => Task.Run(() => work(call, cancellation), cancellation);

    private static CommandAction Printing(Action<CommandCall> print) => (call, _) =>
    {
        print(call);
        return Task.FromResult(0);
    };
}

/// <summary>The action of a command.</summary>
/// <param name="call">Options of the call.</param>
/// <param name="cancellation">Cancels the work, as Ctrl-C does.</param>
/// <returns>The exit code.</returns>
internal delegate Task<int> CommandAction(CommandCall call, CancellationToken cancellation);

/// <summary>One call of a command.</summary>
/// <param name="Values">Options of the call, including those from configuration files.</param>
/// <param name="Words">All words of the command line, with the words of response files inserted in their places.</param>
/// <param name="Host">The world.</param>
internal sealed record CommandCall(OptionValues Values, IReadOnlyList<string> Words, ProgramHost Host);
