namespace Msisf.Core.Terrain;

/// <summary>Finds out whether the Moon is between a camera and what it is to look at.</summary>
public static class SightLine
{
    /// <summary>
    /// 1: points of the line that are compared with the ground. A line that ends below the horizon runs through the ground for at least
    /// half of its length, or over a mountain at its end.
    /// </summary>
    private const int Points = 256;

    /// <summary>
    /// Whether ground hides a target that lies beyond the camera's horizon. A target that sees the camera above its own horizontal plane
    /// counts as visible: single mountains in between are not looked for.
    /// </summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    /// <param name="targetBodyFixed">Target, m, body-fixed.</param>
    /// <param name="groundRadius">Distance from the Moon's centre to the terrain in a direction, m.</param>
    public static bool IsBlocked(Vector3D positionBodyFixed, Vector3D targetBodyFixed, Func<Vector3D, double> groundRadius)
    {
        Vector3D line = targetBodyFixed - positionBodyFixed;
        return Vector3D.Dot(line, targetBodyFixed) > 0.0 && Enumerable.Range(1, Points - 1).Any(index =>
        {
            Vector3D point = positionBodyFixed + ((double)index / Points * line);
            return point.Length < groundRadius(point);
        });
    }
}
