using Msisf.App.Settings;
using Msisf.App.Settings.Config;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Completion;
using Msisf.Cli.Help;

namespace Msisf.Cli.Commands;

/// <summary>What each command of the table does.</summary>
internal static class CommandActions
{
    private static readonly Dictionary<CommandSpec, CommandAction> Actions = new(ReferenceEqualityComparer.Instance)
    {
        [CommandTable.Render] = RenderCommand.RunAsync,
        [CommandTable.Patterns] = PatternsCommand.RunAsync,
        [CommandTable.BatchConvert] = InBackground(BatchConvertCommand.Run),
        [CommandTable.Submit] = (call, cancellation) => Task.Run(() => SubmitCommand.RunAsync(call, cancellation), cancellation),
        [CommandTable.Status] = InBackground(CheckCommand.Status),
        [CommandTable.Verify] = InBackground(CheckCommand.Verify),
        [CommandTable.Merge] = (call, cancellation) => Task.Run(() => MergeCommand.RunAsync(call, cancellation), cancellation),
        [CommandTable.Synthesize] = InBackground(SynthesizeCommand.Run),
        [CommandTable.Pyramid] = InBackground(PyramidCommand.Run),
        [CommandTable.ConfigShow] = Printing(call => Configuration.Show(call.Values.Text(RunOptions.Config), call.Host)),
        [CommandTable.Completion] = Printing(call => call.Host.Results.Write(CompletionScript.For(call.Values.Argument!))),
        [CommandTable.Man] = Printing(call => call.Host.Results.Write(ManualPage.Text(call.Host.Version))),
    };

    /// <summary>What a command does that has none below it, or is the program itself.</summary>
    public static CommandAction Of(CommandSpec command) => Actions[command];

    /// <summary>Work that takes time, off the thread that waits for Ctrl-C.</summary>
    private static CommandAction InBackground(Func<CommandCall, CancellationToken, int> work) =>
        (call, cancellation) => Task.Run(() => work(call, cancellation), cancellation);

    private static CommandAction Printing(Action<CommandCall> print) => (call, _) =>
    {
        print(call);
        return Task.FromResult(0);
    };
}
