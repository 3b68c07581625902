namespace Msisf.Core.Navigation;

/// <summary>Where the rim of a crater is taken to lie.</summary>
public enum CraterRim
{
    /// <summary>On the disc in the plane through the centre of the crater.</summary>
    Disc,

    /// <summary>On the highest ground around the crater.</summary>
    Terrain,
}
