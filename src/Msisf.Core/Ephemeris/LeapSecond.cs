namespace Msisf.Core.Ephemeris;

/// <summary>One step of TAI - UTC.</summary>
/// <param name="TaiMinusUtc">s, from <paramref name="UtcSeconds"/> on.</param>
/// <param name="UtcSeconds">When it begins: seconds past 2000-01-01T12:00:00 UTC, each day counted with 86 400 s.</param>
public sealed record LeapSecond(double TaiMinusUtc, double UtcSeconds);
