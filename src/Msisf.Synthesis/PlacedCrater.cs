using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

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
