using Msisf.Core.Numerics;

namespace Msisf.Core.Orbit;

/// <summary>
/// Position and velocity relative to the Moon's centre, in the frame of the orbit (<see cref="OrbitFrame"/>); <c>default</c> is at rest
/// at the Moon's centre.
/// </summary>
/// <param name="Position">m.</param>
/// <param name="Velocity">m/s.</param>
public readonly record struct StateVector(Vector3D Position, Vector3D Velocity);
