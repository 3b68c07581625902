using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// A block of samples of a polar map with their directions, line by line with <see cref="Stride"/> elements each; the elements after the
/// block's samples continue the line.
/// </summary>
internal sealed class MapFrame
{
    private const double FullTurn = 360.0;

    /// <summary>Samples from one place with an exact latitude and longitude to the next, where those between are interpolated.</summary>
    private const int Step = 8;

    /// <summary>Blocks whose lines and samples are multiples of this can be interpolated.</summary>
    public const int WholeSteps = 2 * Step;

    /// <summary>m: less than the steps of the surface's vertices.</summary>
    /// <param name="cell">m: width of the surface's cells.</param>
    public static double LeastShift(double cell) => 1e-5 * Math.Max(cell, 1.0);

    private static readonly (double First, double Second, double Third)[] SampleWeights =
        [.. Enumerable.Range(0, 2 * Step).Select(sample => Weights(sample / (double)Step))];

    /// <summary>Makes the tables of a block.</summary>
    /// <param name="projection">The map.</param>
    /// <param name="firstLine">Top line.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="samples">How many samples.</param>
    /// <param name="maxShift">
    /// m: latitudes and longitudes are interpolated where that shifts places by less than this; above 0 the block must be whole steps wide.
    /// </param>
    public MapFrame(
        PolarStereographic projection, int firstLine, int lines, int firstSample, int samples, double maxShift = 0.0)
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
        }

        Middle = projection.DirectionOf(firstLine + (0.5 * lines), firstSample + (0.5 * Stride));
        foreach (int line in new[] { firstLine, firstLine + lines })
        {
            foreach (int sample in new[] { firstSample, firstSample + Stride })
            {
                Farthest = Math.Max(Farthest, Vector3D.AngleBetween(Middle, projection.DirectionOf(line, sample)));
            }
        }

        if (MayInterpolate(maxShift))
        {
            Interpolate();
        }
        else
        {
            for (int index = 0; index < X.Length; index++)
            {
                (Latitudes[index], Longitudes[index]) = PlaceOf(new Vector3D(X[index], Y[index], Z[index]));
            }
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

    /// <summary>x of each sample's direction, body-fixed.</summary>
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

    /// <summary>Direction of the middle of the block, body-fixed, length 1.</summary>
    public Vector3D Middle { get; }

    /// <summary>How far samples are from the middle at most, radii of the Moon.</summary>
    public double Farthest { get; }

    /// <summary>degrees: the southernmost and the northernmost sample.</summary>
    public (double South, double North) LatitudeRange => (Latitudes.Min(), Latitudes.Max());

    /// <summary>
    /// degrees: latitudes and longitudes of a rectangle that holds all samples, whatever the middle of the map is; the width is 360 if a
    /// pole may be among them.
    /// </summary>
    public (double South, double North, double West, double Width) Around() => GroundPoints.Around(Middle, Farthest);

    private static (double Latitude, double Longitude) PlaceOf(Vector3D direction)
    {
        SelenographicPoint point = SelenographicPoint.Below(direction);
        return (
            double.RadiansToDegrees(point.Latitude),
            Math.Min(double.RadiansToDegrees(point.Longitude), Math.BitDecrement(FullTurn)));
    }

    /// <summary>
    /// Whether quadratics through every eighth sample are near enough: with h between these and r from the Moon's axis, they shift places
    /// along a parallel by up to h^3 / (4 r^2), and less along a meridian.
    /// </summary>
    private bool MayInterpolate(double maxShift)
    {
        double step = Step * Projection.MetresPerPixel;
        double fromAxis = double.PositiveInfinity;
        foreach (int corner in new[] { 0, Stride - 1, X.Length - Stride, X.Length - 1 })
        {
            fromAxis = Math.Min(fromAxis, double.Hypot(X[corner], Y[corner]) * MoonConstants.ReferenceRadius);
        }

        fromAxis -= (Lines + Stride) * Projection.MetresPerPixel;
        return fromAxis > 0.0 && step * step * step < 4.0 * fromAxis * fromAxis * maxShift;
    }

    /// <summary>Quadratics along lines through every eighth sample, and down between every eighth line.</summary>
    private void Interpolate()
    {
        int rows = (Lines / Step) + 1;
        int columns = (Stride / Step) + 1;
        double[] latitudes = new double[rows * columns];
        double[] longitudes = new double[latitudes.Length];
        double middle = PlaceOf(Projection.DirectionOf(FirstLine + (0.5 * Lines), FirstSample + (0.5 * Stride))).Longitude;
        for (int node = 0; node < latitudes.Length; node++)
        {
            (double latitude, double longitude) = PlaceOf(
                Projection.DirectionOf(FirstLine + (node / columns * Step), FirstSample + (node % columns * Step)));
            (latitudes[node], longitudes[node]) = (latitude, middle + Math.IEEERemainder(longitude - middle, FullTurn));
        }

        Interpolate(latitudes, columns, Latitudes);
        Interpolate(longitudes, columns, Longitudes);
        for (int index = 0; index < Longitudes.Length; index++)
        {
            double longitude = Longitudes[index];
            Longitudes[index] = longitude < 0.0 ? longitude + FullTurn : longitude >= FullTurn ? longitude - FullTurn : longitude;
        }
    }

    private void Interpolate(double[] nodes, int columns, double[] values)
    {
        for (int line = 0; line < Lines; line++)
        {
            int row = line / (2 * Step) * 2;
            (double n0, double n1, double n2) = Weights((line - (row * Step)) / (double)Step);
            for (int first = 0; first + 2 < columns; first += 2)
            {
                int at = (row * columns) + first;
                double a = Down(at);
                double b = Down(at + 1);
                double c = Down(at + 2);
                for (int sample = 0; sample < 2 * Step; sample++)
                {
                    (double w0, double w1, double w2) = SampleWeights[sample];
                    values[(line * Stride) + (first * Step) + sample] = (w0 * a) + (w1 * b) + (w2 * c);
                }
            }

            double Down(int at) => (n0 * nodes[at]) + (n1 * nodes[at + columns]) + (n2 * nodes[at + (2 * columns)]);
        }
    }

    /// <summary>Weights of three places, one step from each other.</summary>
    /// <param name="t">Steps from the first.</param>
    private static (double First, double Second, double Third) Weights(double t) =>
        (0.5 * (1.0 - t) * (2.0 - t), t * (2.0 - t), 0.5 * t * (t - 1.0));

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
