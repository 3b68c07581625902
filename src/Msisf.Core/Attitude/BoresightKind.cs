namespace Msisf.Core.Attitude;

/// <summary>What a camera looks at.</summary>
public enum BoresightKind
{
    /// <summary>The Moon's centre; the default.</summary>
    Nadir,

    /// <summary>A place on, above or below the surface.</summary>
    Place,

    /// <summary>The Sun.</summary>
    Sun,

    /// <summary>The horizon of the reference sphere in an azimuth.</summary>
    Horizon,

    /// <summary>At an angle from the nadir, towards an azimuth.</summary>
    OffNadir,
}
