using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tracing;

/// <summary>
/// A sphere around the Moon's centre, seen from outside. A ray from inside it (a camera in a crater below the reference radius) meets no
/// point of it: the far side, thousands of kilometres behind the ground, is not what the pixel shows. Immutable.
/// </summary>
public sealed class ReferenceSphere : ISurface
{
    private readonly double _radius;

    /// <summary>Makes a sphere.</summary>
    /// <param name="radius">Radius, m, above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is not finite or not above 0.</exception>
    public ReferenceSphere(double radius)
    {
        if (!(radius > 0.0 && double.IsFinite(radius)))
        {
            throw new ArgumentOutOfRangeException(nameof(radius), radius, "A sphere's radius is finite and above 0 m.");
        }

        _radius = radius;
    }

    /// <summary>The sphere to which the heights of the Moon's elevation models refer (docs/deviations.md, row 8).</summary>
    public static ReferenceSphere Lola { get; } = new(MoonConstants.ReferenceRadius);

    /// <inheritdoc/>
    /// <remarks>
    /// Replaces the discriminant of thesis eq. 8.4: the nearest approach to the centre is computed by cross products, and then half the
    /// chord is subtracted. Neither step depends on the distance of the origin, so no digits are lost to cancellation between 1 m and 1e12
    /// m. A tangent ray hits.
    /// </remarks>
    public bool TryFirstHit(Ray ray, out Vector3D pointBodyFixed)
    {
        Vector3D direction = ray.Direction.Normalized();
        Vector3D nearest = Vector3D.Cross(direction, Vector3D.Cross(ray.Origin, direction)) / direction.LengthSquared;
        double nearestDistance = nearest.Length;
        bool looksInward = Vector3D.Dot(ray.Origin, direction) < 0.0;
        if (!(looksInward && nearestDistance <= _radius && ray.Origin.Length >= _radius))
        {
            pointBodyFixed = default;
            return false;
        }

        double halfChord = Math.Sqrt((_radius - nearestDistance) * (_radius + nearestDistance));
        pointBodyFixed = nearest - (halfChord * direction);
        return true;
    }
}
