namespace Msisf.Core.Attitude;

/// <summary>The axes into which the quaternion of an attitude turns the camera's axes (docs/camera-model.md).</summary>
public enum AttitudeFrame
{
    /// <summary>MOON_ME at the time of the image, which turns with the Moon; the default.</summary>
    MoonMe,

    /// <summary>The MOON_ME axes of the epoch, held inertial.</summary>
    MoonMeEpoch,

    /// <summary>J2000 (ICRF) axes.</summary>
    J2000,

    /// <summary>
    /// Local vertical, local horizontal: z to the Moon's centre, y against the orbit's angular momentum, x across both, forward.
    /// </summary>
    Lvlh,
}
