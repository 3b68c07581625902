namespace Msisf.Core.Detector.Psf;

/// <summary>Stray light far from the point's image: (1 + (r / r0)^2)^(-b / 2).</summary>
/// <param name="coreRadius">r0, px, above 0.</param>
/// <param name="exponent">b, above 2, so that the energy is finite.</param>
public sealed class WingSpread(double coreRadius, double exponent) : IRadialSpread
{
    /// <inheritdoc/>
    public double Scale => coreRadius;

    /// <inheritdoc/>
    public double At(double radius)
    {
        double inCores = radius / coreRadius;
        return Math.Pow(1.0 + (inCores * inCores), -0.5 * exponent);
    }
}
