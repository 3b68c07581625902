using Msisf.Cli.Run;
using Spectre.Console;

namespace Msisf.Cli.Progress;

/// <summary>Chooses how progress is shown.</summary>
internal static class RunProgress
{
    /// <summary>A bar on a terminal, lines elsewhere and with <c>--batch</c>, nothing for a single step.</summary>
    public static IRunProgress Start(string title, int total, bool unattended, Log log, TimeProvider clock)
    {
        if (DrawsBar(total, unattended))
        {
            return StartBar(title, total);
        }

        return total > 1 ? new PlainProgress(log, clock, total) : new SilentProgress();
    }

    /// <summary>Whether a bar is drawn.</summary>
    public static bool DrawsBar(int total, bool unattended) => total > 1 && !unattended && !Console.IsErrorRedirected;

    // Apart, so that Spectre.Console is only loaded when a bar is drawn.
    private static BarProgress StartBar(string title, int total) =>
        new(AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) }), title, total);
}
