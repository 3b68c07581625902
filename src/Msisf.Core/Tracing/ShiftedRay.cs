using Msisf.Core.Camera;

namespace Msisf.Core.Tracing;

/// <summary>A ray whose origin has been moved along it, so that it is near the Moon.</summary>
/// <param name="Ray">
/// The moved ray on the same line; its points with parameters from -<paramref name="Offset"/> on belong to the original ray.
/// </param>
/// <param name="Offset">Added to a parameter of the moved ray, it gives the parameter on the original ray.</param>
/// <remarks>
/// Relative to an origin at 1e9 m a vertex is rounded by 1e-7 m; relative to an origin near the Moon, by 1e-10 m. The moved line deviates
/// from the original one by the same small amount, because its origin is computed with 106 bits.
/// </remarks>
internal readonly record struct ShiftedRay(Ray Ray, double Offset)
{
    /// <summary>
    /// Moves the origin to the ray's nearest approach to the Moon's centre, if it is farther from that centre than a distance in m.
    /// </summary>
    public static ShiftedRay From(Ray ray, double farDistance)
    {
        double length = ray.Direction.Length;
        double offset = -Vector3D.Dot(ray.Origin, ray.Direction / length) / length;
        if (!(ray.Origin.Length > farDistance && offset > 0.0))
        {
            return new ShiftedRay(ray, 0.0);
        }

        return new ShiftedRay(ray with { Origin = Stable.PointAlong(ray.Origin, offset, ray.Direction) }, offset);
    }
}
