using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// An invented global shape of the Moon for models without a base, 1 sample a degree: hills from a thousand km down to 60 km, a lower
/// near side, and flat maria in its low ground. Heights are within 4.2 km of the reference radius; it has no craters.
/// </summary>
/// <remarks>
/// The slopes follow those of LDEM_4: median 3.6 degrees at 7.6 km and 1.5 degrees at 61 km on highlands, so about baseline^-0.45.
/// </remarks>
internal sealed class SyntheticShape : IGlobalGrid
{
    private const int Lines = 180;
    private const int Samples = 360;
    private const double CoarsestSpacing = 1_600_000.0; // m
    private const double FinestSpacing = 50_000.0; // m: a little under two samples
    private const double FinestOfTheLows = 400_000.0; // m: maria are as wide as waves down to this
    private const double SlopeAt7580Metres = 0.0627; // tangent
    private const double SlopeExponent = -0.45;
    private const double MareRoughness = 0.12; // part of the highlands'
    private const double NearSideDrop = 1100.0; // m
    private const double FloodedPart = 0.4; // of the depth below the lava's level
    private const double LavaLevel = -2000.0; // m
    private const double LimitHeight = 4200.0; // m: smooth limit, so that with craters no seed leaves the Moon's range

    private readonly double[] _radii = new double[Lines * Samples];

    /// <summary>Makes the shape of a seed.</summary>
    public SyntheticShape(ulong seed)
    {
        TileFrame frame = new(pixelsPerDegree: 1, 0, Lines, 0, Samples);
        float[] lows = new float[frame.Stride];
        float[] hills = new float[frame.Stride];
        float[] maria = new float[frame.Stride];
        (NoiseOctave Octave, double[] Tables)[] octaves = [.. Octaves(seed).Select(octave => (octave, octave.ColumnTables(frame)))];
        for (int line = 0; line < Lines; line++)
        {
            Array.Clear(lows);
            Array.Clear(maria);
            foreach ((NoiseOctave octave, double[] tables) in octaves.Where(pair => pair.Octave.Spacing >= FinestOfTheLows))
            {
                octave.AddTo(tables, frame.SinLatitude[line], frame.CosLatitude[line], maria, lows);
            }

            for (int sample = 0; sample < Samples; sample++)
            {
                double nearSide = frame.CosLatitude[line] * frame.CosLongitude[sample];
                lows[sample] -= (float)(NearSideDrop * nearSide);
                maria[sample] = (float)MareMask.FractionOf(lows[sample], nearSide);
            }

            Array.Clear(hills);
            foreach ((NoiseOctave octave, double[] tables) in octaves.Where(pair => pair.Octave.Spacing < FinestOfTheLows))
            {
                octave.AddTo(tables, frame.SinLatitude[line], frame.CosLatitude[line], maria, hills);
            }

            for (int sample = 0; sample < Samples; sample++)
            {
                _radii[(line * Samples) + sample] = MoonConstants.ReferenceRadius
                    + Limited(Flooded(lows[sample], maria[sample]) + hills[sample]);
            }
        }
    }

    /// <inheritdoc/>
    public string ProductId => "LDEM_1_SYNTHETIC";

    /// <inheritdoc/>
    public int PixelsPerDegree => 1;

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] = _radii[(line * Samples) + ((firstSample + i) % Samples)];
        }
    }

    private static IEnumerable<NoiseOctave> Octaves(ulong seed)
    {
        for (double spacing = CoarsestSpacing; spacing >= FinestSpacing; spacing *= 0.5)
        {
            double slope = SlopeAt7580Metres * PortableMath.Pow(spacing / 2.0 / 7580.0, SlopeExponent);
            double power = 1.0 - PortableMath.Exp2(2.0 * SlopeExponent);
            double amplitude = slope * Math.Sqrt(power) * spacing / GradientNoise.RmsSlope;
            yield return new NoiseOctave(seed, spacing, amplitude, MareRoughness * amplitude);
        }
    }

    // Lava fills low ground to about the same level.
    private static double Flooded(double height, double mareFraction) => height + (mareFraction * FloodedPart * (LavaLevel - height));

    private static double Limited(double height) => height / Math.Sqrt(1.0 + (height * height / (LimitHeight * LimitHeight)));
}
