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
