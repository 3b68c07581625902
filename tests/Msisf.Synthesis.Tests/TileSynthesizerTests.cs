using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class TileSynthesizerTests
{
    // m: heights leave as floats, 2.4e-4 m a step at 4 km.
    private const double FloatMean = 2e-4;

    // 1: medians of a few thousand independent slopes, and a law that craters and noise share by estimate.
    private const double SlopeLawPart = 0.15;

    private const double MetresPerDegree = 1_737_400.0 * Math.PI / 180.0;

    [Theory]
    [InlineData(0, 0)]
    [InlineData(160, 1430)]
    [InlineData(634, 700)]
    public void Synthesize_WithBase_KeepsTheBasesPixelMeans(int pixelLine, int pixel)
    {
        const int Ratio = 4;
        FunctionGrid baseModel = FunctionGrid.Hilly(4);
        if (pixelLine == 0)
        {
            pixelLine = 81; // 69.6 degrees north: the last lines but one whose means are kept
        }

        float[] heights = Block(new SyntheticTerrain(4 * Ratio, 1, baseModel), Ratio * pixelLine, 20, Ratio * pixel, 40);
        double[] radii = new double[10];
        for (int i = 0; i < 5; i++)
        {
            baseModel.ReadRadii(pixelLine + i, pixel, radii);
            for (int j = 0; j < 10; j++)
            {
                double sum = 0.0;
                for (int k = 0; k < Ratio * Ratio; k++)
                {
                    sum += heights[(((i * Ratio) + (k / Ratio)) * 40) + (j * Ratio) + (k % Ratio)];
                }

                Assert.Equal(radii[j] - MoonConstants.ReferenceRadius, sum / (Ratio * Ratio), FloatMean);
            }
        }
    }

    [Theory]
    [InlineData(true, 30, 0)]
    [InlineData(true, 0, 5752)]
    [InlineData(true, 2800, 3000)]
    [InlineData(false, 0, 100)]
    [InlineData(false, 1400, 5740)]
    public void Synthesize_OtherBlocks_GiveTheSameBits(bool withBase, int firstLine, int firstSample)
    {
        SyntheticTerrain terrain = new(16, 1, withBase ? FunctionGrid.Hilly(4) : null);
        float[] whole = Block(terrain, firstLine, 60, firstSample, 20);
        float[] part = Block(terrain, firstLine + 13, 40, firstSample + 3, 9);
        for (int line = 0; line < 40; line++)
        {
            Assert.Equal(whole.AsSpan(((line + 13) * 20) + 3, 9), part.AsSpan(line * 9, 9));
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Synthesize_AtPrimeMeridianAndPole_IsAsSmoothAsElsewhere(bool withBase)
    {
        const int Resolution = 16;
        SyntheticTerrain terrain = new(Resolution, 4, withBase ? FunctionGrid.OfHeights(4, (_, _) => 0.0) : null);
        float[] west = Block(terrain, 80 * Resolution, 512, (360 * Resolution) - 32, 32);
        float[] east = Block(terrain, 80 * Resolution, 512, 0, 32);
        double elsewhere = Rms(Enumerable.Range(0, 512).Select(line => east[(line * 32) + 16] - east[(line * 32) + 15]));
        double seam = Rms(Enumerable.Range(0, 512).Select(line => east[line * 32] - west[(line * 32) + 31]));
        Assert.InRange(seam / elsewhere, 0.6, 1.6);

        // The northernmost line goes round the pole at 950 m: neighbours opposite each other are 1900 m apart, as elsewhere.
        float[] first = [.. Enumerable.Range(0, 4).SelectMany(quarter => Block(terrain, 0, 1, quarter * 90 * Resolution, 90 * Resolution))];
        double across = Rms(Enumerable.Range(0, 180 * Resolution).Select(sample => first[sample] - first[sample + (180 * Resolution)]));
        double along = Rms(Enumerable.Range(1, first.Length - 1).Select(sample => first[sample] - first[sample - 1]));
        Assert.InRange(across, 0.0, 3.0 * elsewhere);
        Assert.InRange(along, 0.0, 0.02 * elsewhere);
    }

    [Theory]
    [InlineData(false, 6.3607034)] // tests/reference/portable_math.py: the law at 473.80 m
    [InlineData(true, 0.90019299)]
    public void Synthesize_64SamplesADegree_HasTheMedianSlopeOfTheLaw(bool mare, double expectedDegrees)
    {
        const int Resolution = 64;
        const int Side = 3 * Resolution;
        SyntheticTerrain terrain = new(Resolution, 11, FunctionGrid.HighlandsAndMare(4));
        float[] heights = Block(terrain, 88 * Resolution, Side, mare ? 10 * Resolution : 170 * Resolution, Side);
        Assert.InRange(
            MedianSlopeDegrees(heights, Side, Resolution), (1.0 - SlopeLawPart) * expectedDegrees, (1.0 + SlopeLawPart) * expectedDegrees);
    }

    [Fact]
    public void Synthesize_OtherSeed_IsOtherTerrain()
    {
        FunctionGrid baseModel = FunctionGrid.HighlandsAndMare(4);
        float[] one = Block(new SyntheticTerrain(32, 1, baseModel), 2880, 64, 5000, 64);
        float[] two = Block(new SyntheticTerrain(32, 2, baseModel), 2880, 64, 5000, 64);
        double correlation = one.Zip(two, (a, b) => (double)a * b).Sum()
            / Math.Sqrt(one.Sum(a => (double)a * a) * two.Sum(b => (double)b * b));
        Assert.InRange(correlation, -0.3, 0.3);
    }

    private static double MedianSlopeDegrees(float[] heights, int side, int resolution)
    {
        double spacing = MetresPerDegree / resolution;
        List<double> slopes = [];
        for (int line = 0; line < side - 1; line++)
        {
            for (int sample = 0; sample < side - 1; sample++)
            {
                int i = (line * side) + sample;
                slopes.Add(double.Hypot(heights[i + 1] - heights[i], heights[i + side] - heights[i]) / spacing);
            }
        }

        slopes.Sort();
        return Math.Atan(slopes[slopes.Count / 2]) * 180.0 / Math.PI;
    }

    private static double Rms(IEnumerable<float> values) => Math.Sqrt(values.Average(value => (double)value * value));

    private static float[] Block(SyntheticTerrain terrain, int firstLine, int lines, int firstSample, int samples)
    {
        float[] heights = new float[lines * samples];
        new TileSynthesizer(terrain).Synthesize(firstLine, lines, firstSample, samples, heights);
        return heights;
    }
}
