namespace Msisf.Core.Illumination;

/// <summary>A vertex of the terrain as it is seen from a place.</summary>
/// <param name="East">m.</param>
/// <param name="North">m.</param>
/// <param name="Up">m.</param>
/// <param name="Column">Azimuth in columns, from 0 to the columns of a turn.</param>
/// <param name="Tangent">Tangent of the elevation.</param>
internal readonly record struct HorizonPoint(double East, double North, double Up, float Column, float Tangent)
{
    /// <summary>The lowest tangent: straight down.</summary>
    public const float Lowest = -1e6f;

    /// <summary>Finds where a vertex is seen.</summary>
    /// <param name="columns">Columns of a turn.</param>
    /// <param name="frame">The place.</param>
    /// <param name="positionBodyFixed">The vertex, m, body-fixed.</param>
    public static HorizonPoint Of(int columns, in LocalFrame frame, Vector3D positionBodyFixed)
    {
        Vector3D local = frame.ToLocal(positionBodyFixed - frame.PositionBodyFixed);
        double across = double.Sqrt((local.X * local.X) + (local.Y * local.Y)); // m on one body: no overflow
        double turns = Math.Atan2(local.X, local.Y) / (2.0 * Math.PI);
        return new HorizonPoint(
            local.X, local.Y, local.Z, (float)((turns < 0.0 ? turns + 1.0 : turns) * columns),
            across > 0.0 ? Math.Max(Lowest, (float)(local.Z / across)) : Lowest);
    }
}
