namespace Msisf.App.Host;

/// <summary>Shows the progress of a run with several steps. Thread-safe.</summary>
internal interface IRunProgress : IDisposable
{
    /// <summary>Reports that one step is done.</summary>
    /// <param name="name">Name of the step.</param>
    void Advance(string name);
}
