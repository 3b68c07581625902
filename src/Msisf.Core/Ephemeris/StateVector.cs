using Msisf.Core.Numerics;

namespace Msisf.Core.Ephemeris;

/// <summary>
/// Position and velocity relative to a body's centre, in the frame that its user names; <c>default</c> is at rest at the centre.
/// </summary>
/// <param name="Position">m; within kernels km.</param>
/// <param name="Velocity">m/s; within kernels km/s.</param>
public readonly record struct StateVector(Vector3D Position, Vector3D Velocity)
{
    /// <summary>Adds, so that a chain of centres becomes one state.</summary>
    public static StateVector operator +(StateVector a, StateVector b) => new(a.Position + b.Position, a.Velocity + b.Velocity);

    /// <summary>The state relative to that of another body.</summary>
    public static StateVector operator -(StateVector a, StateVector b) => new(a.Position - b.Position, a.Velocity - b.Velocity);

    /// <summary>Changes the unit of length.</summary>
    public static StateVector operator *(double factor, StateVector a) => new(factor * a.Position, factor * a.Velocity);

    /// <summary>Turns both along the axes of a frame that does not turn itself.</summary>
    public static StateVector operator *(RotationMatrix rotation, StateVector a) => new(rotation * a.Position, rotation * a.Velocity);
}
