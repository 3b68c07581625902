using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Where the Sun is at the times of images. Not for several threads, as CSPICE is not.</summary>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="aberration">Which effects of light's finite speed are included.</param>
/// <param name="isShared">Whether several cameras ask for the same times: then each is computed once, and kept.</param>
internal sealed class SunPositions(Func<IEphemeris> ephemeris, Aberration aberration, bool isShared = false)
{
    private readonly Dictionary<double, Vector3D> _known = [];

    /// <summary>m, body-fixed.</summary>
    public Vector3D At(ModifiedJulianDate time)
    {
        if (!isShared)
        {
            return Compute(time);
        }

        if (!_known.TryGetValue(time.Days, out Vector3D position))
        {
            _known.Add(time.Days, position = Compute(time));
        }

        return position;
    }

    private Vector3D Compute(ModifiedJulianDate time) => ephemeris().SunPositionBodyFixed(time, aberration);
}
