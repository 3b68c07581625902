namespace Msisf.Core.Attitude;

/// <summary>Which direction points up in the image, as far as the line of sight allows.</summary>
public enum UpDirection
{
    /// <summary>Away from the Moon's centre, so that the horizon is level; the default.</summary>
    Zenith,

    /// <summary>The Moon's north pole.</summary>
    North,

    /// <summary>The Sun.</summary>
    Sun,
}
