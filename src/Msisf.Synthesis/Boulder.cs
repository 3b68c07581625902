using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>A boulder on the ground: the upper half of an ellipsoid with three different axes.</summary>
/// <param name="Centre">Direction of its middle, MOON_ME, length 1.</param>
/// <param name="Narrow">Horizontal direction in which it is narrower, MOON_ME, length 1.</param>
/// <param name="Radius">m: half of its length.</param>
/// <param name="WidthPart">Its width, in lengths.</param>
/// <param name="Height">m.</param>
internal readonly record struct Boulder(Vector3D Centre, Vector3D Narrow, double Radius, double WidthPart, double Height)
{
    /// <summary>Height over the ground in a direction of length 1, m; 0 beside it.</summary>
    public double HeightAt(Vector3D direction)
    {
        Vector3D from = direction - Centre;
        double across = Vector3D.Dot(from, Narrow);
        double stretch = (1.0 / (WidthPart * WidthPart)) - 1.0;
        double radius = Radius / MoonConstants.ReferenceRadius;
        double square = (from.LengthSquared + (stretch * across * across)) / (radius * radius);
        return square < 1.0 ? Height * Math.Sqrt(1.0 - square) : 0.0;
    }
}
