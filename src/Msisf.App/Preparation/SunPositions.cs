using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Where the Sun is at the times of images. Not for several threads, as CSPICE is not.</summary>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="aberration">Which effects of light's finite speed are included.</param>
/// <param name="known">Keeps what several cameras ask for; null where one does.</param>
internal sealed class SunPositions(Func<IEphemeris> ephemeris, Aberration aberration, KnownSuns? known = null)
{
    /// <summary>m, body-fixed.</summary>
    public Vector3D At(ModifiedJulianDate time)
    {
        IEphemeris engine = ephemeris();
        if (known is null)
        {
            return engine.SunPositionBodyFixed(time, aberration);
        }

        if (!known.TryGetValue((time.Days, aberration, engine), out Vector3D position))
        {
            known.Add((time.Days, aberration, engine), position = engine.SunPositionBodyFixed(time, aberration));
        }

        return position;
    }
}

/// <summary>Positions of the Sun by time (MJD), aberration and ephemeris.</summary>
internal sealed class KnownSuns : Dictionary<(double Days, Aberration Aberration, IEphemeris Engine), Vector3D>;
