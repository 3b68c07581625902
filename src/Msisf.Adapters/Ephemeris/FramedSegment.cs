using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>A segment whose states are given in another frame than J2000.</summary>
/// <param name="frameFromJ2000">The frame at a time in TDB seconds past J2000.</param>
internal sealed class FramedSegment(IEphemerisSegment segment, Func<double, RotationMatrix> frameFromJ2000) : IEphemerisSegment
{
    /// <summary>
    /// s: the velocity by a frame that turns as fast as the Earth, 7e-5 rad/s, is then right to 1e-13 km/s; the frame's rounding adds
    /// 1e-11.
    /// </summary>
    private const double Step = 20.0;

    public int Body => segment.Body;

    public int Center => segment.Center;

    public TdbInterval Interval => segment.Interval;

    public Vector3D ValueAt(double tdbSeconds) => frameFromJ2000(tdbSeconds).Transposed * segment.ValueAt(tdbSeconds);

    public Vector3D RateAt(double tdbSeconds) => StateAt(tdbSeconds).Velocity;

    public StateVector StateAt(double tdbSeconds)
    {
        StateVector inFrame = segment.StateAt(tdbSeconds);
        StateVector turned = frameFromJ2000(tdbSeconds).Transposed * inFrame;
        return turned with { Velocity = turned.Velocity + ((8.0 * Difference(Step) - Difference(2.0 * Step)) / (12.0 * Step)) };

        Vector3D Difference(double step) => (frameFromJ2000(tdbSeconds + step).Transposed * inFrame.Position)
            - (frameFromJ2000(tdbSeconds - step).Transposed * inFrame.Position);
    }
}
