using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>An elevation grid whose radii a function of line and sample gives.</summary>
internal sealed class FunctionGrid(int pixelsPerDegree, Func<int, int, double> radiusOf) : IElevationGrid
{
    public string ProductId => "TEST_GRID";

    public int PixelsPerDegree => pixelsPerDegree;

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

    /// <summary>Heights in m over the reference radius.</summary>
    public static FunctionGrid OfHeights(int pixelsPerDegree, Func<int, int, double> heightOf) =>
        new(pixelsPerDegree, (line, sample) => MoonConstants.ReferenceRadius + heightOf(line, sample));

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] = radiusOf(line, (firstSample + i) % (360 * pixelsPerDegree));
        }
    }

    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples) =>
        throw new NotSupportedException("Not needed by what is tested with functions.");
}
