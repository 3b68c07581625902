using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// A block of samples of a polar map with their directions, line by line with <see cref="Stride"/> elements each; the elements after the
/// block's samples continue the line.
/// </summary>
internal sealed class MapFrame
{
    private const double FullTurn = 360.0;

    /// <summary>Makes the tables of a block.</summary>
    /// <param name="projection">The map.</param>
    /// <param name="firstLine">Top line.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="samples">How many samples.</param>
    public MapFrame(PolarStereographic projection, int firstLine, int lines, int firstSample, int samples)
    {
        Projection = projection;
        (FirstLine, Lines, FirstSample, Samples) = (firstLine, lines, firstSample, samples);
        Stride = (samples + TileFrame.VectorWidth - 1) / TileFrame.VectorWidth * TileFrame.VectorWidth;
        X = new double[lines * Stride];
        Y = new double[X.Length];
        Z = new double[X.Length];
        Latitudes = new double[X.Length];
        Longitudes = new double[X.Length];
        for (int index = 0; index < X.Length; index++)
        {
            Vector3D direction = projection.DirectionOf(firstLine + (index / Stride), firstSample + (index % Stride));
            (X[index], Y[index], Z[index]) = (direction.X, direction.Y, direction.Z);
            SelenographicPoint point = SelenographicPoint.Below(direction);
            Latitudes[index] = double.RadiansToDegrees(point.Latitude);
            Longitudes[index] = Math.Min(double.RadiansToDegrees(point.Longitude), Math.BitDecrement(FullTurn));
        }

        (West, Width) = LongitudeRange();
    }

    /// <summary>The map.</summary>
    public PolarStereographic Projection { get; }

    /// <summary>Top line in the map.</summary>
    public int FirstLine { get; }

    /// <summary>How many lines.</summary>
    public int Lines { get; }

    /// <summary>Leftmost sample in the map.</summary>
    public int FirstSample { get; }

    /// <summary>How many samples.</summary>
    public int Samples { get; }

    /// <summary>Number of elements from one line to the next.</summary>
    public int Stride { get; }

    /// <summary>x of each sample's direction, MOON_ME.</summary>
    public double[] X { get; }

    /// <summary>y of each sample's direction.</summary>
    public double[] Y { get; }

    /// <summary>z of each sample's direction.</summary>
    public double[] Z { get; }

    /// <summary>Latitude of each sample, degrees.</summary>
    public double[] Latitudes { get; }

    /// <summary>Longitude of each sample, degrees, [0, 360).</summary>
    public double[] Longitudes { get; }

    /// <summary>degrees: a western border of all samples.</summary>
    public double West { get; }

    /// <summary>degrees: how far they reach to the east of it, 360 if the pole is among them.</summary>
    public double Width { get; }

    /// <summary>degrees: the southernmost and the northernmost sample.</summary>
    public (double South, double North) LatitudeRange => (Latitudes.Min(), Latitudes.Max());

    /// <summary>
    /// degrees: latitudes and longitudes of a rectangle that holds all samples, whatever the middle of the map is; the width is 360 if a
    /// pole may be among them.
    /// </summary>
    public (double South, double North, double West, double Width) Around()
    {
        Vector3D middle = Projection.DirectionOf(FirstLine + (0.5 * Lines), FirstSample + (0.5 * Stride)).Normalized();
        double reach = 0.0;
        foreach (int line in new[] { FirstLine, FirstLine + Lines })
        {
            foreach (int sample in new[] { FirstSample, FirstSample + Stride })
            {
                reach = Math.Max(reach, Vector3D.AngleBetween(middle, Projection.DirectionOf(line, sample)));
            }
        }

        SelenographicPoint point = SelenographicPoint.Below(middle);
        double latitude = double.RadiansToDegrees(point.Latitude);
        double degrees = double.RadiansToDegrees(reach);
        double sine = Math.Sin(reach) / Math.Cos(point.Latitude);
        if (Math.Abs(latitude) + degrees >= 90.0 || sine >= 1.0)
        {
            return (Math.Max(latitude - degrees, -90.0), Math.Min(latitude + degrees, 90.0), 0.0, FullTurn);
        }

        double half = double.RadiansToDegrees(Math.Atan2(sine, Math.Sqrt((1.0 - sine) * (1.0 + sine))));
        return (latitude - degrees, latitude + degrees, double.RadiansToDegrees(point.Longitude) - half, 2.0 * half);
    }

    private (double West, double Width) LongitudeRange()
    {
        // Within a rectangle without the pole the longitude is extreme at a corner. A pixel is added on each side.
        double line = Projection.LineOffset - FirstLine;
        double sample = Projection.SampleOffset - FirstSample;
        if (line >= -1.0 && line <= Lines && sample >= -1.0 && sample <= Stride)
        {
            return (0.0, FullTurn);
        }

        double middle = Longitude(FirstLine + (0.5 * Lines), FirstSample + (0.5 * Stride));
        double west = 0.0;
        double east = 0.0;
        foreach (int cornerLine in new[] { FirstLine - 1, FirstLine + Lines })
        {
            foreach (int cornerSample in new[] { FirstSample - 1, FirstSample + Stride })
            {
                double turn = Math.IEEERemainder(Longitude(cornerLine, cornerSample) - middle, FullTurn);
                west = Math.Min(west, turn);
                east = Math.Max(east, turn);
            }
        }

        return (middle + west, east - west);
    }

    private double Longitude(double line, double sample) =>
        double.RadiansToDegrees(SelenographicPoint.Below(Projection.DirectionOf(line, sample)).Longitude);
}
