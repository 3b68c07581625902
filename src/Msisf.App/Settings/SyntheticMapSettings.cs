namespace Msisf.App.Settings;

/// <summary>Describes a synthetic polar map to make.</summary>
/// <param name="IsSouth">Whether it is of the south pole.</param>
/// <param name="MetresPerPixel">Map scale, m.</param>
/// <param name="LatitudeDegrees">Absolute latitude of the middle of the map's sides.</param>
internal sealed record SyntheticMapSettings(bool IsSouth, double MetresPerPixel, double LatitudeDegrees);
