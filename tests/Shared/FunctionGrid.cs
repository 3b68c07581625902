using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>An elevation grid whose radii a function of line and sample gives.</summary>
internal sealed class FunctionGrid(int pixelsPerDegree, Func<int, int, double> radiusOf) : IGlobalGrid
{
    public string ProductId => "TEST_GRID";

    public int PixelsPerDegree => pixelsPerDegree;

    public double ReferenceRadius { get; init; } = MoonConstants.ReferenceRadius;

    /// <summary>Heights of +-5 km that jump from sample to sample, by a fixed integer hash.</summary>
    public static FunctionGrid Rough(int pixelsPerDegree) => new(
        pixelsPerDegree,
        (line, sample) => 1_737_400.0 + ((((line * 7919) + (sample * 104729)) % 20011 * 0.5) - 5000.0));

    /// <summary>Heights without any order, up to 300 m: the hardest case for an interpolation.</summary>
    public static FunctionGrid Hilly(int pixelsPerDegree) => OfHeights(
        pixelsPerDegree,
        (line, sample) => ((((line * 7919) + (sample * 104729)) % 1009) * 0.6) - 300.0);

    /// <summary>Highlands at height 0; on the near side one flat mare.</summary>
    public static FunctionGrid HighlandsAndMare(int pixelsPerDegree) => OfHeights(
        pixelsPerDegree,
        (_, sample) => Math.Cos((sample + 0.5) / pixelsPerDegree * Math.PI / 180.0) > 0.5 ? -2500.0 : 0.0);

    /// <summary>
    /// Mountains and valleys of all sizes down to single samples, within <see cref="RuggedRelief"/>; on the far side a bowl 5 km deep
    /// at <see cref="RuggedBowlDegrees"/>. Slopes up to some 40 degrees at any resolution.
    /// </summary>
    public static FunctionGrid Rugged(int pixelsPerDegree)
    {
        int octaves = 1 + (int)Math.Log(pixelsPerDegree * 60.0, 4.0);
        double[] alongMeridian = Waves(
            180 * pixelsPerDegree, pixelsPerDegree, octaves, k => (1200.0 * Math.Pow(0.36, k), 3 << (2 * k), 0.7 * k));
        double[] alongParallel = Waves(360 * pixelsPerDegree, pixelsPerDegree, octaves, k => (1.0, 4 << (2 * k), 1.9 * k));
        double[] ofLine = Bowl(180 * pixelsPerDegree, pixelsPerDegree, 90.0 - RuggedBowlDegrees.Latitude, 1.5);
        double[] ofSample = Bowl(360 * pixelsPerDegree, pixelsPerDegree, RuggedBowlDegrees.Longitude, 4.5);
        double roughness = 6000.0 / pixelsPerDegree;
        return OfHeights(pixelsPerDegree, (line, sample) =>
        {
            double height = (((((line * 7919) ^ (sample * 104729)) * 40503 >> 8) & 1023) / 1024.0 - 0.5) * roughness;
            ReadOnlySpan<double> waves = alongMeridian.AsSpan(line * octaves, octaves);
            ReadOnlySpan<double> others = alongParallel.AsSpan(sample * octaves, octaves);
            for (int k = 0; k < waves.Length && k < others.Length; k++)
            {
                height += waves[k] * others[k];
            }

            return Math.Clamp(height, -3000.0, 3000.0) - (5000.0 * ofLine[line] * ofSample[sample]);
        });
    }

    /// <summary>The heights of <see cref="Rugged"/> over another sphere.</summary>
    public static FunctionGrid RuggedOn(double radius, int pixelsPerDegree)
    {
        FunctionGrid moon = Rugged(pixelsPerDegree);
        return new FunctionGrid(pixelsPerDegree, (line, sample) => moon.RadiusAt(line, sample) - MoonConstants.ReferenceRadius + radius)
        {
            ReferenceRadius = radius,
        };
    }

    /// <summary>m: how far <see cref="Rugged"/> is from the reference radius at most.</summary>
    public static double RuggedRelief => 8000.0;

    /// <summary>Degrees: the middle of the bowl of <see cref="Rugged"/>, near the Moon's deepest place.</summary>
    public static (double Latitude, double Longitude) RuggedBowlDegrees => (-70.4, 187.4);

    /// <summary>Heights in m over the reference radius.</summary>
    public static FunctionGrid OfHeights(int pixelsPerDegree, Func<int, int, double> heightOf) =>
        new(pixelsPerDegree, (line, sample) => MoonConstants.ReferenceRadius + heightOf(line, sample));

    public double RadiusAt(int line, int sample) => radiusOf(line, sample);

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] = radiusOf(line, (firstSample + i) % (360 * pixelsPerDegree));
        }
    }

    /// <summary>Sines with so many periods a turn: all of them for the first sample of a line, or line of a meridian, and so on.</summary>
    private static double[] Waves(
        int count, int pixelsPerDegree, int octaves, Func<int, (double Amplitude, int Periods, double Phase)> waveOf)
    {
        double[] waves = new double[count * octaves];
        for (int k = 0; k < octaves; k++)
        {
            (double amplitude, int periods, double phase) = waveOf(k);
            for (int i = 0; i < count; i++)
            {
                waves[(i * octaves) + k] = amplitude * Math.Sin((periods * (i + 0.5) / pixelsPerDegree * Math.PI / 180.0) + phase);
            }
        }

        return waves;
    }

    /// <summary>1 at the centre, 0 from a distance on, smooth between; degrees.</summary>
    private static double[] Bowl(int count, int pixelsPerDegree, double centre, double radius) =>
        [.. Enumerable.Range(0, count)
            .Select(i => Math.Abs(((i + 0.5) / pixelsPerDegree) - centre) / radius)
            .Select(distance => distance < 1.0 ? 0.5 + (0.5 * Math.Cos(Math.PI * distance)) : 0.0)];
}
