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

/// <summary>
/// Shows progress as plain lines with the remaining time, for files and unattended runs; at most one line every few seconds.
/// </summary>
internal sealed class PlainProgress(ILog log, TimeProvider clock, int total) : IRunProgress
{
    private static readonly TimeSpan MinPause = TimeSpan.FromSeconds(2.0);

    private readonly Lock _gate = new();
    private readonly long _start = clock.GetTimestamp();
    private long _lastLine = clock.GetTimestamp();
    private int _done;

    public void Advance(string name)
    {
        lock (_gate)
        {
            _done++;
            if (_done < total && clock.GetElapsedTime(_lastLine) < MinPause)
            {
                return;
            }

            _lastLine = clock.GetTimestamp();
            TimeSpan left = clock.GetElapsedTime(_start) * ((double)(total - _done) / _done);
            log.Note(Invariant($"{_done} of {total} done ({name}), {left:hh\\:mm\\:ss} left"));
        }
    }

    public void Dispose()
    {
    }
}
