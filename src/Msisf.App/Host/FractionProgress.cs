namespace Msisf.App.Host;

/// <summary>Turns a fraction into whole steps, from any thread.</summary>
/// <param name="progress">Gets <see cref="Steps"/> steps.</param>
/// <param name="name">What is going on.</param>
internal sealed class FractionProgress(IRunProgress progress, string name) : IProgress<double>
{
    /// <summary>Steps in which progress is shown.</summary>
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
