namespace Msisf.App.Host;

/// <summary>Shows how far runs are.</summary>
internal interface IProgressDisplay
{
    /// <summary>Begins to show a run of several steps; disposing the result ends it.</summary>
    /// <param name="title">What is going on.</param>
    /// <param name="total">Steps.</param>
    /// <param name="unattended">Nobody watches.</param>
    IRunProgress Start(string title, int total, bool unattended);
}
