using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// One octave of roughness: noise of one wavelength, evaluated in space on the sphere, so that it has no seam at the poles or the prime
/// meridian.
/// </summary>
/// <remarks>
/// The lattice of each octave has its own random rotation, because aligned lattices show as a grid where the sphere is parallel to their
/// planes.
/// </remarks>
internal sealed class NoiseOctave
{
    private const ulong Purpose = 1;

    private readonly double[,] _latticeFromMoon = new double[3, 3];
    private readonly double[] _origin = new double[3];
    private readonly int _latticeSeed;
    private readonly float _highlandsAmplitude;
    private readonly float _mariaExtraAmplitude;

    /// <summary>Makes an octave.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="spacing">m between lattice points.</param>
    /// <param name="highlandsAmplitude">m; factor of the noise where there is no mare.</param>
    /// <param name="mariaAmplitude">m; factor of the noise on full mare.</param>
    public NoiseOctave(ulong seed, double spacing, double highlandsAmplitude, double mariaAmplitude)
    {
        Spacing = spacing;
        _highlandsAmplitude = (float)highlandsAmplitude;
        _mariaExtraAmplitude = (float)(mariaAmplitude - highlandsAmplitude);

        // Keyed by the spacing in mm, so that an octave is the same in every product that contains it.
        SplitMix64 random = SplitMix64.For(seed, Purpose, (long)Math.Round(1000.0 * spacing), 0);
        _latticeSeed = (int)random.NextBits();
        Turn(ref random, MoonConstants.ReferenceRadius / spacing);
        for (int axis = 0; axis < 3; axis++)
        {
            _origin[axis] = 1024.0 * random.NextUniform();
        }
    }

    /// <summary>Distance between lattice points, m; the wavelengths are one to two times this.</summary>
    public double Spacing { get; }

    /// <summary>
    /// The part of the lattice coordinates that depends on the column: three tables of the frame's stride, one after the other.
    /// </summary>
    public double[] ColumnTables(TileFrame frame)
    {
        double[] tables = new double[3 * frame.Stride];
        for (int axis = 0; axis < 3; axis++)
        {
            for (int column = 0; column < frame.Stride; column++)
            {
                tables[(axis * frame.Stride) + column] =
                    (_latticeFromMoon[axis, 0] * frame.CosLongitude[column]) + (_latticeFromMoon[axis, 1] * frame.SinLongitude[column]);
            }
        }

        return tables;
    }

    /// <summary>Adds the octave to one line of heights, m.</summary>
    /// <param name="columnTables">From <see cref="ColumnTables"/>.</param>
    /// <param name="sinLatitude">Sine of the latitude of the line.</param>
    /// <param name="cosLatitude">Cosine of the latitude of the line.</param>
    /// <param name="mareFraction">0 (highlands) to 1 (mare), one a column.</param>
    /// <param name="heights">m, one a column; as many as the frame's stride.</param>
    public void AddTo(
        ReadOnlySpan<double> columnTables,
        double sinLatitude,
        double cosLatitude,
        ReadOnlySpan<float> mareFraction,
        Span<float> heights)
    {
        int stride = heights.Length;
        ReadOnlySpan<double> tableX = columnTables[..stride];
        ReadOnlySpan<double> tableY = columnTables.Slice(stride, stride);
        ReadOnlySpan<double> tableZ = columnTables.Slice(2 * stride, stride);
        Vector256<double> cos = Vector256.Create(cosLatitude);
        Vector256<double> x = Vector256.Create((_latticeFromMoon[0, 2] * sinLatitude) + _origin[0]);
        Vector256<double> y = Vector256.Create((_latticeFromMoon[1, 2] * sinLatitude) + _origin[1]);
        Vector256<double> z = Vector256.Create((_latticeFromMoon[2, 2] * sinLatitude) + _origin[2]);
        Vector256<float> highlands = Vector256.Create(_highlandsAmplitude);
        Vector256<float> mariaExtra = Vector256.Create(_mariaExtraAmplitude);
        for (int i = 0; i < stride; i += TileFrame.VectorWidth)
        {
            int j = i + 4;
            Vector256<float> noise = GradientNoise.At(
                (cos * Vector256.Create(tableX[i..])) + x,
                (cos * Vector256.Create(tableX[j..])) + x,
                (cos * Vector256.Create(tableY[i..])) + y,
                (cos * Vector256.Create(tableY[j..])) + y,
                (cos * Vector256.Create(tableZ[i..])) + z,
                (cos * Vector256.Create(tableZ[j..])) + z,
                _latticeSeed);
            Vector256<float> amplitude = highlands + (mariaExtra * Vector256.Create(mareFraction[i..]));
            (Vector256.Create((ReadOnlySpan<float>)heights[i..]) + (amplitude * noise)).CopyTo(heights[i..]);
        }
    }

    /// <summary>Adds the octave at any directions.</summary>
    /// <param name="x">x of the directions, body-fixed; a multiple of <see cref="TileFrame.VectorWidth"/> of them.</param>
    /// <param name="y">y of the directions.</param>
    /// <param name="z">z of the directions.</param>
    /// <param name="mareFraction">0 (highlands) to 1 (mare).</param>
    /// <param name="heights">m.</param>
    public void AddTo(
        ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, ReadOnlySpan<float> mareFraction, Span<float> heights)
    {
        for (int i = 0; i < heights.Length; i += TileFrame.VectorWidth)
        {
            Vector256<float> noise = GradientNoise.At(
                Lattice(0, x, y, z, i), Lattice(0, x, y, z, i + 4), Lattice(1, x, y, z, i), Lattice(1, x, y, z, i + 4),
                Lattice(2, x, y, z, i), Lattice(2, x, y, z, i + 4), _latticeSeed);
            Vector256<float> amplitude =
                Vector256.Create(_highlandsAmplitude) + (Vector256.Create(_mariaExtraAmplitude) * Vector256.Create(mareFraction[i..]));
            (Vector256.Create((ReadOnlySpan<float>)heights[i..]) + (amplitude * noise)).CopyTo(heights[i..]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<double> Lattice(int axis, ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, int first) =>
        (Vector256.Create(_latticeFromMoon[axis, 0]) * Vector256.Create(x[first..]))
        + (Vector256.Create(_latticeFromMoon[axis, 1]) * Vector256.Create(y[first..]))
        + (Vector256.Create(_latticeFromMoon[axis, 2]) * Vector256.Create(z[first..]))
        + Vector256.Create(_origin[axis]);

    // A uniformly random rotation from four numbers in the unit ball (Marsaglia 1972), times the scale from unit sphere to lattice.
    private void Turn(ref SplitMix64 random, double scale)
    {
        double w, x, y, z, square;
        do
        {
            w = (2.0 * random.NextUniform()) - 1.0;
            x = (2.0 * random.NextUniform()) - 1.0;
            y = (2.0 * random.NextUniform()) - 1.0;
            z = (2.0 * random.NextUniform()) - 1.0;
            square = (w * w) + (x * x) + (y * y) + (z * z);
        }
        while (square is > 1.0 or < 0.01);

        double s = 2.0 / square;
        double[,] rotation =
        {
            { 1.0 - (s * ((y * y) + (z * z))), s * ((x * y) - (w * z)), s * ((x * z) + (w * y)) },
            { s * ((x * y) + (w * z)), 1.0 - (s * ((x * x) + (z * z))), s * ((y * z) - (w * x)) },
            { s * ((x * z) - (w * y)), s * ((y * z) + (w * x)), 1.0 - (s * ((x * x) + (y * y))) },
        };
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 3; column++)
            {
                _latticeFromMoon[row, column] = scale * rotation[row, column];
            }
        }
    }
}
