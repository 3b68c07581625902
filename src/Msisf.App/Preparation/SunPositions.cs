using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Where the Sun is at the times of images. Not for several threads, as CSPICE is not.</summary>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="aberration">Which effects of light's finite speed are included.</param>
/// <param name="shared">Keeps what several cameras ask for; null where one does.</param>
internal sealed class SunPositions(Func<IEphemeris> ephemeris, Aberration aberration, SharedReadings? shared = null)
{
    /// <summary>m, body-fixed.</summary>
    public Vector3D At(ModifiedJulianDate time)
    {
        IEphemeris engine = ephemeris();
        return shared?.SunAt(time, aberration, engine) ?? engine.SunPositionBodyFixed(time, aberration);
    }
}
