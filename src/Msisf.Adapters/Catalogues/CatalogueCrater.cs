namespace Msisf.Adapters.Catalogues;

/// <summary>A crater of a catalogue.</summary>
/// <param name="Name">Null where the catalogue has none.</param>
/// <param name="LatitudeDegrees">Planetocentric, [-90, 90].</param>
/// <param name="LongitudeDegrees">East, [0, 360).</param>
/// <param name="Diameter">m.</param>
public sealed record CatalogueCrater(string? Name, double LatitudeDegrees, double LongitudeDegrees, double Diameter);
