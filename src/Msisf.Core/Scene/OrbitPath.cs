using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>The camera of a spacecraft on an orbit. As thread-safe as the orbit's ephemeris.</summary>
/// <param name="orbit">Where the spacecraft is.</param>
/// <param name="attitude">How its camera points; null for straight down with north up.</param>
public sealed class OrbitPath(OrbitPropagator orbit, FramedAttitude? attitude) : ICameraPath
{
    /// <inheritdoc/>
    public TdbCover Cover => TdbCover.Everything;

    /// <inheritdoc/>
    public CameraState At(Instant time)
    {
        Vector3D position = orbit.PositionBodyFixed(time);
        return new CameraState(position, Attitude(time, position));
    }

    /// <summary>How the camera moves, by the velocity and the rates that orbit and attitude have.</summary>
    /// <exception cref="MsisfException">The time is outside the kernels' cover, or the orbit can't be followed up to it.</exception>
    public CameraMotion MotionAt(Instant time)
    {
        StateVector state = orbit.StateBodyFixed(time);
        return new CameraMotion(
            state.Velocity,
            attitude?.RateOverBody(time, Attitude(time, state.Position), orbit.TurningBodyFixed)
                ?? NadirPointing.RateOf(state.Position, state.Velocity));
    }

    private UnitQuaternion Attitude(Instant time, Vector3D position) =>
        attitude?.MoonFromCamera(time, position, orbit.NormalBodyFixed) ?? NadirPointing.MoonFromCamera(position);
}
