using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tests.Support;

/// <summary>Where rays pass.</summary>
internal static class RayGeometry
{
    /// <summary>m: how near a ray comes to the Moon's centre.</summary>
    public static double NearestApproach(Ray ray)
    {
        Vector3D direction = ray.Direction.Normalized();
        return Vector3D.Dot(ray.Origin, direction) >= 0.0 ? ray.Origin.Length : Vector3D.Cross(ray.Origin, direction).Length;
    }
}
