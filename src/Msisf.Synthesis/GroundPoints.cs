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

    /// <summary>Places spread evenly over a cell of a model.</summary>
    /// <param name="model">The model.</param>
    /// <param name="line">The cell's line.</param>
    /// <param name="sample">Its sample.</param>
    /// <param name="side">Places along each of its sides.</param>
    public static GroundPoints Within(ITerrainGrid model, int line, int sample, int side)
    {
        int count = side * side;
        GroundPoints points = new(new double[count], new double[count], new double[count], new double[count], new double[count]);
        double First(int index) => index - 0.5 + (0.5 / side);
        if (model.Projection is Equirectangular(var perDegree))
        {
            double[] longitudes = [.. Enumerable.Range(0, side).Select(i => (First(sample) + 0.5 + ((double)i / side)) / perDegree)];
            (double Sin, double Cos)[] columns = [.. longitudes.Select(PortableMath.SinCosDegrees)];
            for (int row = 0; row < side; row++)
            {
                double latitude = 90.0 - ((First(line) + 0.5 + ((double)row / side)) / perDegree);
                (double sin, double cos) = PortableMath.SinCosDegrees(latitude);
                for (int column = 0; column < side; column++)
                {
                    Vector3D direction = new(cos * columns[column].Cos, cos * columns[column].Sin, sin);
                    points.Set((row * side) + column, direction, latitude, longitudes[column]);
                }
            }

            return points;
        }

        for (int i = 0; i < count; i++)
        {
            Vector3D direction = model.Projection.DirectionOf(
                First(line) + ((double)(i / side) / side), First(sample) + ((double)(i % side) / side));
            SelenographicPoint point = SelenographicPoint.Below(direction);
            points.Set(i, direction, double.RadiansToDegrees(point.Latitude), double.RadiansToDegrees(point.Longitude));
        }

        return points;
    }

    private void Set(int index, Vector3D direction, double latitude, double longitude)
    {
        (X[index], Y[index], Z[index]) = (direction.X, direction.Y, direction.Z);
        (Latitudes[index], Longitudes[index]) = (latitude, longitude);
    }

    /// <summary>
    /// degrees: latitudes and longitudes of a rectangle that holds all within an angle of a direction; the width is 360 if a pole may be
    /// among them.
    /// </summary>
    /// <param name="middle">The direction, length 1.</param>
    /// <param name="reach">rad.</param>
    public static (double South, double North, double West, double Width) Around(Vector3D middle, double reach)
    {
        SelenographicPoint point = SelenographicPoint.Below(middle);
        double latitude = double.RadiansToDegrees(point.Latitude);
        double degrees = double.RadiansToDegrees(reach);
        double sine = Math.Sin(reach) / Math.Cos(point.Latitude);
        if (Math.Abs(latitude) + degrees >= 90.0 || sine >= 1.0)
        {
            return (Math.Max(latitude - degrees, -90.0), Math.Min(latitude + degrees, 90.0), 0.0, 360.0);
        }

        double half = double.RadiansToDegrees(Math.Atan2(sine, Math.Sqrt((1.0 - sine) * (1.0 + sine))));
        return (latitude - degrees, latitude + degrees, double.RadiansToDegrees(point.Longitude) - half, 2.0 * half);
    }

    /// <summary>Direction of a place.</summary>
    public Vector3D this[int index] => new(X[index], Y[index], Z[index]);
}
