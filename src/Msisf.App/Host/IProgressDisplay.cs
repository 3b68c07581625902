namespace Msisf.App.Host;

/// <summary>Shows the progress of runs.</summary>
internal interface IProgressDisplay
{
    /// <summary>Starts the display of a run with several steps; disposing the result ends it.</summary>
    /// <param name="title">Name of the work.</param>
    /// <param name="total">Number of steps.</param>
    /// <param name="unattended">Whether the run is unattended, so that no progress bar is drawn.</param>
    IRunProgress Start(string title, int total, bool unattended);
}
