using Msisf.App.Host;
using Spectre.Console;

namespace Msisf.Cli.Output;

/// <summary>A progress bar with the remaining time, for a terminal.</summary>
internal sealed class BarProgress : IRunProgress
{
    private readonly ManualResetEventSlim _finished = new();
    private readonly Task _drawing;
    private readonly ProgressTask _bar;
    private readonly Action _atEnd;

    public BarProgress(IAnsiConsole console, string title, int total, Action atEnd)
    {
        _atEnd = atEnd;
        TaskCompletionSource<ProgressTask> started = new();
        _drawing = Task.Run(() => console
            .Progress()
            .Columns(
                new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RemainingTimeColumn(),
                new SpinnerColumn())
            .Start(context =>
            {
                started.SetResult(context.AddTask(Markup.Escape(title), maxValue: total));
                _finished.Wait(); // as long as the run takes: Dispose ends it
            }));

        // On a terminal without support for bars, the drawing task fails before it signals its start.
        if (Task.WaitAny(started.Task, _drawing) != 0)
        {
            _drawing.GetAwaiter().GetResult();
        }

        _bar = started.Task.Result;
    }

    public void Advance(string name) => _bar.Increment(1.0);

    public void Dispose()
    {
        _finished.Set();
        _drawing.GetAwaiter().GetResult();
        _finished.Dispose();
        _atEnd();
    }
}
