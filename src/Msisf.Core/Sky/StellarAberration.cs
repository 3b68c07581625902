namespace Msisf.Core.Sky;

/// <summary>The direction in which a moving observer sees light come.</summary>
public static class StellarAberration
{
    /// <summary>The direction from the moving observer, by special relativity.</summary>
    /// <param name="direction">From an observer at rest in the same place, length 1.</param>
    /// <param name="velocityInC">Velocity of the observer over that of light, along the same axes; shorter than 1.</param>
    /// <returns>Length 1.</returns>
    /// <remarks>
    /// P. K. Seidelmann (ed.), Explanatory Supplement to the Astronomical Almanac (1992), eq. 3.252-3. The Sun's deflection of light, 4 mas
    /// at 90 degrees from the Sun and 0.4 arcseconds at 1 degree, is left out.
    /// </remarks>
    public static Vector3D Of(Vector3D direction, Vector3D velocityInC)
    {
        double inverseGamma = Math.Sqrt(1.0 - velocityInC.LengthSquared);
        double along = Vector3D.Dot(direction, velocityInC);
        Vector3D seen = ((inverseGamma * direction) + ((1.0 + (along / (1.0 + inverseGamma))) * velocityInC)) / (1.0 + along);
        return seen.Normalized();
    }
}
