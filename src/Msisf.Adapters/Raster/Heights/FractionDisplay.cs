namespace Msisf.Adapters.Raster.Heights;

/// <summary>Shows how far a work has come.</summary>
/// <param name="progress">Receives the fraction that is done.</param>
/// <param name="display">Ends the display.</param>
public sealed class FractionDisplay(IProgress<double> progress, IDisposable display) : IDisposable
{
    /// <summary>Receives the fraction that is done.</summary>
    public IProgress<double> Progress => progress;

    /// <summary>Ends the display.</summary>
    public void Dispose() => display.Dispose();
}
