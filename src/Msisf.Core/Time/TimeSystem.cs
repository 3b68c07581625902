namespace Msisf.Core.Time;

/// <summary>The systems in which a moment has a date and a time of day.</summary>
public enum TimeSystem
{
    /// <summary>Coordinated Universal Time, with leap seconds.</summary>
    Utc,

    /// <summary>International Atomic Time.</summary>
    Tai,

    /// <summary>Terrestrial Time: TAI + 32.184 s.</summary>
    Tt,

    /// <summary>Barycentric Dynamical Time, in which kernels count.</summary>
    Tdb,

    /// <summary>The Global Positioning System's time: TAI - 19 s.</summary>
    Gps,
}
