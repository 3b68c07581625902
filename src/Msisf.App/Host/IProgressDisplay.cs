namespace Msisf.App.Host;

/// <summary>Shows the progress of runs.</summary>
internal interface IProgressDisplay
{
    /// <summary>Starts the display of a run with several steps; disposing the result ends it.</summary>
    /// <param name="title">Name of the work.</param>
    /// <param name="unattended">Whether the run is unattended, so that no progress bar is drawn.</param>
    IRunProgress Start(string title, int total, bool unattended);
}

/// <summary>Shows the progress of a run with several steps. Thread-safe.</summary>
internal interface IRunProgress : IDisposable
{
    /// <summary>Reports that one step is done.</summary>
    void Advance(string name);
}

/// <summary>Shows no progress.</summary>
internal sealed class NoProgress : IProgressDisplay, IRunProgress
{
    public IRunProgress Start(string title, int total, bool unattended) => this;

    public void Advance(string name)
    {
    }

    public void Dispose()
    {
    }
}

/// <summary>Converts a fraction from 0 to 1, reported by any thread, to whole steps of a progress display.</summary>
/// <param name="progress">The progress display; it receives <see cref="Steps"/> steps.</param>
/// <param name="name">Name of the work, for the display.</param>
internal sealed class FractionProgress(IRunProgress progress, string name) : IProgress<double>
{
    /// <summary>Number of steps from 0 to 1.</summary>
    public const int Steps = 100;

    private readonly Lock _gate = new();
    private int _steps;

    public void Report(double value)
    {
        lock (_gate)
        {
            for (; _steps < (int)(value * Steps); _steps++)
            {
                progress.Advance(name);
            }
        }
    }
}
