namespace Msisf.Synthesis;

/// <summary>One crater.</summary>
/// <param name="SinLatitude">Of the centre.</param>
/// <param name="LongitudeDegrees">Of the centre, [0, 360).</param>
/// <param name="Radius">m, centre to rim crest.</param>
/// <param name="Freshness">1 new; the depth is this part of a new crater's.</param>
internal readonly record struct Crater(double SinLatitude, double LongitudeDegrees, double Radius, double Freshness)
{
    /// <summary>Radii to which the ejecta blanket is drawn.</summary>
    public const double Reach = 3.0;

    /// <summary>Cosine of the centre's latitude.</summary>
    public double CosLatitude => Math.Sqrt((1.0 - SinLatitude) * (1.0 + SinLatitude));

    /// <summary>Latitude of the centre.</summary>
    public double LatitudeDegrees => Math.Atan2(SinLatitude, CosLatitude) * (180.0 / Math.PI);
}
