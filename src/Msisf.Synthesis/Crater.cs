using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>One crater.</summary>
/// <param name="SinLatitude">Sine of the centre's latitude.</param>
/// <param name="LongitudeDegrees">Longitude of the centre, degrees, [0, 360).</param>
/// <param name="Radius">m, centre to rim crest.</param>
/// <param name="Freshness">Depth as a fraction of a new crater's depth; 1 for a new crater.</param>
internal readonly record struct Crater(double SinLatitude, double LongitudeDegrees, double Radius, double Freshness)
{
    /// <summary>Crater radii: distance from the centre to which the ejecta blanket extends.</summary>
    public const double Reach = 3.0;

    /// <summary>Cosine of the centre's latitude.</summary>
    public double CosLatitude => Math.Sqrt((1.0 - SinLatitude) * (1.0 + SinLatitude));

    /// <summary>Direction of the centre, body-fixed, length 1.</summary>
    public Vector3D Direction
    {
        get
        {
            (double sinLongitude, double cosLongitude) = PortableMath.SinCosDegrees(LongitudeDegrees);
            return new Vector3D(CosLatitude * cosLongitude, CosLatitude * sinLongitude, SinLatitude);
        }
    }

    /// <summary>Latitude of the centre, degrees.</summary>
    public double LatitudeDegrees => Math.Atan2(SinLatitude, CosLatitude) * (180.0 / Math.PI);
}

/// <summary>A crater with all that follows from it, which is needed for each block of ground that it reaches.</summary>
internal readonly struct PlacedCrater
{
    /// <summary>Places a crater.</summary>
    public PlacedCrater(Crater crater)
    {
        Direction = crater.Direction;
        Profile = new CraterProfile(crater, isSharp: true);
        Freshness = crater.Freshness;
        Radius = crater.Radius / MoonConstants.ReferenceRadius;
        Diameter = 2.0 * crater.Radius;
    }

    /// <summary>Direction of the centre, body-fixed, length 1.</summary>
    public Vector3D Direction { get; }

    /// <summary>Its heights.</summary>
    public CraterProfile Profile { get; }

    /// <summary>Centre to rim crest, radii of the Moon.</summary>
    public double Radius { get; }

    /// <summary>Depth as a fraction of a new crater's depth.</summary>
    public double Freshness { get; }

    /// <summary>m, rim crest to rim crest.</summary>
    public double Diameter { get; }
}
