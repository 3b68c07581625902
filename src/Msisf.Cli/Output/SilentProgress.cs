namespace Msisf.App.Host;

/// <summary>Says nothing: for a run of one step.</summary>
internal sealed class SilentProgress : IRunProgress
{
    public void Advance(string name)
    {
    }

    public void Dispose()
    {
    }
}
