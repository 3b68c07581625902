namespace Msisf.Core.Detector.Psf;

/// <summary>A point spread function that depends on the distance from the point's image only. Not normalised. Immutable.</summary>
public interface IRadialSpread
{
    /// <summary>px: length over which the function changes; the integration takes steps of half of it.</summary>
    double Scale { get; }

    /// <summary>The function.</summary>
    /// <param name="radius">px, at least 0.</param>
    double At(double radius);
}

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
