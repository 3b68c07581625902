namespace Msisf.Core.Detector.Psf;

/// <summary>Stray light over the whole image: a part of each pixel's light spreads by a power law. Immutable.</summary>
/// <param name="Fraction">Part of the light, 0 to 1.</param>
/// <param name="CoreRadius">r0 of (1 + (r / r0)^2)^(-b / 2), px, above 0.</param>
/// <param name="Exponent">b, above 2.</param>
/// <param name="Reach">px: no light goes farther; the part is that within.</param>
/// <remarks>J. E. Harvey, SPIE 0107 (1977) 41: scatter of polished surfaces.</remarks>
public sealed record FarWings(double Fraction, double CoreRadius, double Exponent, double Reach)
{
    /// <summary>px: maximum <see cref="Reach"/>.</summary>
    public const double MaxReach = 16_384.0;

    /// <summary>The function, not normalised.</summary>
    internal WingSpread Spread => new(CoreRadius, Exponent);

    /// <summary>px^2: integral of the function over the disc within <see cref="Reach"/>.</summary>
    internal double Integral => 2.0 * Math.PI * CoreRadius * CoreRadius / (Exponent - 2.0)
        * (1.0 - Math.Pow(1.0 + (Reach / CoreRadius * (Reach / CoreRadius)), 1.0 - (0.5 * Exponent)));
}
