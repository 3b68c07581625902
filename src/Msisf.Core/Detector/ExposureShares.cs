namespace Msisf.Core.Detector;

/// <summary>How many pixels of a frame show lit ground, and how many of them the exposure does not suit.</summary>
/// <param name="Lit">Pixels with light of the Sun.</param>
/// <param name="Saturated">Those of them at the highest DN or at the full well.</param>
/// <param name="Empty">Those of them in which light makes less than one DN.</param>
public readonly record struct ExposureShares(long Lit, long Saturated, long Empty)
{
    /// <summary>The counts of two frames together.</summary>
    public static ExposureShares operator +(ExposureShares a, ExposureShares b) =>
        new(a.Lit + b.Lit, a.Saturated + b.Saturated, a.Empty + b.Empty);
}
