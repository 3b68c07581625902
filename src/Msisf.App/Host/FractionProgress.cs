namespace Msisf.App.Host;

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
