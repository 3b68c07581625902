namespace Msisf.Core.Navigation;

/// <summary>A crater of a catalogue: an ellipse on the ground, of most catalogues a circle. Immutable.</summary>
/// <param name="Number">The catalogue's row, from 1, without its heading.</param>
/// <param name="Identity">The catalogue's own name of the row, its number where there is none; no two are the same.</param>
/// <param name="Name">Null where the catalogue has none.</param>
/// <param name="LatitudeDegrees">Planetocentric, [-90, 90].</param>
/// <param name="LongitudeDegrees">East, [0, 360).</param>
/// <param name="Diameter">m: the major axis.</param>
public sealed record Crater(int Number, string Identity, string? Name, double LatitudeDegrees, double LongitudeDegrees, double Diameter)
{
    /// <summary>m: the minor axis; of a circle the same.</summary>
    public double MinorDiameter { get; init; } = Diameter;

    /// <summary>Of the major axis, degrees from east towards north.</summary>
    public double AngleDegrees { get; init; }

    /// <summary>Standard deviations; null where the catalogue has none.</summary>
    public CraterErrors? Errors { get; init; }
}

/// <summary>Standard deviations of a catalogue's crater, taken as independent.</summary>
/// <param name="LatitudeDegrees">Degrees.</param>
/// <param name="LongitudeDegrees">Degrees.</param>
/// <param name="Diameter">m.</param>
/// <param name="MinorDiameter">m.</param>
/// <param name="AngleDegrees">Degrees.</param>
public sealed record CraterErrors(
    double LatitudeDegrees, double LongitudeDegrees, double Diameter, double MinorDiameter, double AngleDegrees);
