using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>Places on the Moon, as directions and as latitudes and longitudes.</summary>
/// <param name="X">x of the directions, body-fixed, length 1.</param>
/// <param name="Y">y.</param>
/// <param name="Z">z.</param>
/// <param name="Latitudes">degrees.</param>
/// <param name="Longitudes">degrees, [0, 360).</param>
internal sealed record GroundPoints(double[] X, double[] Y, double[] Z, double[] Latitudes, double[] Longitudes)
{
    /// <summary>Number of places.</summary>
    public int Count => X.Length;

    /// <summary>The samples of a block.</summary>
    public static GroundPoints Of(MapFrame frame) => new(frame.X, frame.Y, frame.Z, frame.Latitudes, frame.Longitudes);

    /// <summary>One place.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    public static GroundPoints Of(Vector3D direction)
    {
        SelenographicPoint point = SelenographicPoint.Below(direction);
        return new GroundPoints(
            [direction.X], [direction.Y], [direction.Z],
            [double.RadiansToDegrees(point.Latitude)], [double.RadiansToDegrees(point.Longitude)]);
    }

    /// <summary>Direction of a place.</summary>
    public Vector3D this[int index] => new(X[index], Y[index], Z[index]);
}
