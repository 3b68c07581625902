using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>A ray whose origin was moved along it.</summary>
/// <param name="Ray">The same line; points with parameters down to -<paramref name="Offset"/> belong to the ray as it was.</param>
/// <param name="Offset">To be added to a parameter to get that on the ray as it was.</param>
/// <remarks>
/// Relative to an origin at 1e9 m a vertex is rounded by 1e-7 m; relative to one at the Moon by 1e-10 m, and as little is the line
/// itself off when the new origin is computed with 106 bits.
/// </remarks>
internal readonly record struct ShiftedRay(Ray Ray, double Offset)
{
    /// <summary>Moves an origin that is farther than a distance from the Moon's centre to the ray's nearest approach to it.</summary>
    public static ShiftedRay From(Ray ray, double farDistance)
    {
        double length = ray.Direction.Length;
        double offset = -Vector3D.Dot(ray.Origin, ray.Direction / length) / length;
        if (!(ray.Origin.Length > farDistance && offset > 0.0))
        {
            return new ShiftedRay(ray, 0.0);
        }

        Vector3D origin = new(
            Along(ray.Origin.X, offset, ray.Direction.X),
            Along(ray.Origin.Y, offset, ray.Direction.Y),
            Along(ray.Origin.Z, offset, ray.Direction.Z));
        return new ShiftedRay(ray with { Origin = origin }, offset);
    }

    private static double Along(double origin, double parameter, double direction) =>
        (new DoubleDouble(origin, 0.0) + (new DoubleDouble(parameter, 0.0) * new DoubleDouble(direction, 0.0))).High;
}
