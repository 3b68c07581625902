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
