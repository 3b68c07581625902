namespace Msisf.Core.Ephemeris;

/// <summary>
/// A closed stretch of time in TDB seconds past J2000 (2000-01-01T12:00:00 TDB), as kernels count it; <c>default</c> is J2000 alone.
/// </summary>
/// <param name="Start">TDB seconds past J2000.</param>
/// <param name="End">TDB seconds past J2000, not before <paramref name="Start"/>.</param>
public readonly record struct TdbInterval(double Start, double End)
{
    /// <summary>Whether a time is in the interval; both ends belong to it.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    public bool Contains(double tdbSeconds) => tdbSeconds >= Start && tdbSeconds <= End;
}
