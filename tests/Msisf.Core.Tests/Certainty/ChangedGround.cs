using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Certainty;

/// <summary>A model whose heights differ from another's, each for itself, by up to a limit.</summary>
/// <param name="grid">The other model.</param>
/// <param name="reach">m: the limit.</param>
/// <param name="seed">Which differences.</param>
internal sealed class ChangedGround(IGlobalGrid grid, double reach, ulong seed) : IGlobalGrid
{
    public string ProductId => "CHANGED";

    public int PixelsPerDegree => grid.PixelsPerDegree;

    public (double Min, double Max) RadiusLimits => (grid.RadiusLimits.Min - reach, grid.RadiusLimits.Max + reach);

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        grid.ReadRadii(line, firstSample, radii);
        int samples = 360 * PixelsPerDegree;
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] += reach * PartAt(line, (firstSample + i) % samples);
        }
    }

    /// <summary>-1 to 1; half of them at the ends.</summary>
    private double PartAt(int line, int sample)
    {
        // splitmix64 of the place.
        ulong z = seed + (0x9E3779B97F4A7C15UL * (((ulong)(uint)line << 32) | (uint)sample));
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
        z ^= z >> 31;
        double part = ((z >> 11) / (double)(1UL << 52)) - 1.0;
        return (z & 1) == 0 ? part : Math.Sign(part);
    }
}
