namespace Msisf.App.Host;

/// <summary>Shows no progress, for a run of one step.</summary>
internal sealed class SilentProgress : IRunProgress
{
    public void Advance(string name)
    {
    }

    public void Dispose()
    {
    }
}
