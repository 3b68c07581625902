namespace Msisf.Core.Detector.Psf;

/// <summary>exp(-r^2 / (2 sigma^2)).</summary>
/// <param name="sigma">px, above 0.</param>
public sealed class GaussianSpread(double sigma) : IRadialSpread
{
    /// <inheritdoc/>
    public double Scale => sigma;

    /// <inheritdoc/>
    public double At(double radius)
    {
        double inSigmas = radius / sigma;
        return Math.Exp(-0.5 * inSigmas * inSigmas);
    }
}
