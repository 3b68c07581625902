using Msisf.App.Host;
using Spectre.Console;

namespace Msisf.Cli.Output;

/// <summary>
/// Chooses how progress is shown: a bar on a terminal, lines elsewhere and with <c>--batch</c>, nothing for a single step.
/// </summary>
internal sealed class ProgressDisplay(ResultsWriter results, ConsoleLog log, TimeProvider clock) : IProgressDisplay
{
    public IRunProgress Start(string title, int total, bool unattended)
    {
        if (total <= 1)
        {
            return new NoProgress();
        }

        return unattended || Console.IsErrorRedirected ? new PlainProgress(log, clock, total) : StartBar(title, total);
    }

    // A separate method, so that Spectre.Console is only loaded when a bar is drawn. A bar would overwrite other output on its terminal,
    // so that output is held back until the bar ends.
    private BarProgress StartBar(string title, int total)
    {
        log.Hold();
        if (!Console.IsOutputRedirected)
        {
            results.Hold();
        }

        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return new BarProgress(console, title, total, atEnd: () =>
        {
            log.Release();
            results.Release();
        });
    }
}
