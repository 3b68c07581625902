namespace Msisf.Adapters.Synthesis;

/// <summary>The map projection of a synthetic model.</summary>
public enum SyntheticProjection
{
    /// <summary>Latitude and longitude.</summary>
    Cylindrical,

    /// <summary>Polar stereographic around the south pole.</summary>
    PolarSouth,

    /// <summary>Polar stereographic around the north pole.</summary>
    PolarNorth,
}
