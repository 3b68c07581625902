namespace Msisf.App.Host;

/// <summary>Tells the user how far a run with several steps is. Safe for several threads.</summary>
internal interface IRunProgress : IDisposable
{
    /// <summary>One step is done.</summary>
    /// <param name="name">What it was.</param>
    void Advance(string name);
}
