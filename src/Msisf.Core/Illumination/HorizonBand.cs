using Msisf.Core.Terrain;

namespace Msisf.Core.Illumination;

/// <summary>
/// The elevations in which the Sun or the Earth can be over a region of the Moon at any date: horizons need not be known above them.
/// Immutable.
/// </summary>
internal sealed class HorizonBand
{
    /// <summary>degrees: the Sun's latitude on the Moon is within 1.59 degrees of the equator; its disc and parallax are added.</summary>
    private const double SunLatitude = 1.6 + 0.28;

    /// <summary>degrees: libration in latitude, at most 6.9, with the Earth's disc and parallax.</summary>
    private const double EarthLatitude = 6.95 + 1.3;

    /// <summary>degrees: libration in longitude, at most 8.2, with the same.</summary>
    private const double EarthLongitude = 8.3 + 1.3;

    /// <summary>degrees: tangents above that of this elevation need not be told apart.</summary>
    private const double HighestDegrees = 89.0;

    private const double StepDegrees = 0.5;

    /// <summary>Finds the elevations.</summary>
    /// <param name="directions">Places that span the region.</param>
    /// <param name="isMoon">Whether they are on the Moon; on other bodies nothing is known of the Sun.</param>
    /// <param name="bottomDegrees">No horizon is lower.</param>
    /// <param name="columns">Columns of a turn.</param>
    public HorizonBand(IEnumerable<Vector3D> directions, bool isMoon, double bottomDegrees, int columns)
    {
        double[] degrees = new double[columns / HorizonBuffer.Group];
        Array.Fill(degrees, isMoon ? bottomDegrees : HighestDegrees);
        foreach (Vector3D direction in isMoon ? directions : [])
        {
            LocalFrame frame = LocalFrame.At(direction);
            Add(frame, degrees, 180.0, SunLatitude);
            Add(frame, degrees, EarthLongitude, EarthLatitude);
        }

        TopDegrees = Math.Min(HighestDegrees, degrees.Max() + StepDegrees);
        Tops = [.. degrees.Select(top => (float)Math.Tan(double.DegreesToRadians(Math.Min(HighestDegrees, top + StepDegrees))))];
    }

    /// <summary>degrees: nothing is higher anywhere.</summary>
    public double TopDegrees { get; }

    /// <summary>For each group of columns the tangent of the elevation above which nothing needs to be known.</summary>
    public float[] Tops { get; }

    private static void Add(LocalFrame frame, double[] degrees, double halfLongitude, double halfLatitude)
    {
        for (double east = -halfLongitude; east <= halfLongitude; east += StepDegrees)
        {
            for (double north = -halfLatitude; north <= halfLatitude; north += StepDegrees)
            {
                Vector3D local = frame.ToLocal(new SelenographicPoint(
                    double.DegreesToRadians(north), double.DegreesToRadians(east)).ToDirectionBodyFixed());
                double across = double.Hypot(local.X, local.Y);
                double elevation = double.RadiansToDegrees(Math.Atan2(local.Z, across));
                double group = Math.Atan2(local.X, local.Y) / (2.0 * Math.PI) * degrees.Length;
                int reach = (int)Math.Ceiling((1.0 + (StepDegrees / Math.Max(across, 0.01))) * degrees.Length / 360.0);
                for (int away = -reach; away <= Math.Min(reach, degrees.Length - reach); away++)
                {
                    ref double top = ref degrees[((int)Math.Floor(group) + away) & (degrees.Length - 1)];
                    top = Math.Max(top, elevation + StepDegrees);
                }
            }
        }
    }
}
