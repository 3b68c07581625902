using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>A polar map whose heights a function of line and sample gives.</summary>
internal sealed class PolarFunctionGrid(PolarStereographic projection, int lines, int samples, Func<int, int, double> heightOf)
    : ITerrainGrid
{
    private readonly double[] _radii = [.. Enumerable.Range(0, lines * samples)
        .Select(index => MoonConstants.ReferenceRadius + heightOf(index / samples, index % samples))];

    public string ProductId => "TEST_MAP";

    public MapProjection Projection => projection;

    public PolarStereographic Polar => projection;

    public int Lines => lines;

    public int Samples => samples;

    /// <summary>m: all heights of <see cref="Rugged"/> are within this.</summary>
    public double Relief => 4.0 * WidthOfHills(projection.MetresPerPixel);

    public (double Min, double Max) RadiusLimits =>
        (MoonConstants.ReferenceRadius - Relief, MoonConstants.ReferenceRadius + Relief);

    /// <summary>Mountains of all sizes, with slopes up to some 40 degrees at any scale.</summary>
    /// <param name="isSouth">Which pole.</param>
    /// <param name="scale">m/px.</param>
    /// <param name="side">Lines and samples.</param>
    /// <param name="poleLine">Line of the pole.</param>
    /// <param name="poleSample">Sample of the pole.</param>
    public static PolarFunctionGrid Rugged(bool isSouth, double scale, int side, double poleLine, double poleSample) => new(
        new PolarStereographic(isSouth, scale, poleLine, poleSample), side, side, (line, sample) =>
        {
            double rough = (((((line * 7919) ^ (sample * 104729)) * 40503 >> 8) & 1023) / 1024.0) - 0.5;
            double waves = (1.6 * Math.Sin(0.21 * line) * Math.Cos(0.17 * sample)) + (0.7 * Math.Sin(0.61 * (line + sample)));
            return WidthOfHills(scale) * ((0.5 * rough) + waves);
        });

    /// <summary>m: hills of wider cells would be higher than the Moon's.</summary>
    private static double WidthOfHills(double scale) => Math.Min(scale, 3000.0);

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)line, (uint)lines, nameof(line));
        ArgumentOutOfRangeException.ThrowIfGreaterThan((uint)(firstSample + radii.Length), (uint)samples, nameof(radii));
        _radii.AsSpan((line * samples) + firstSample, radii.Length).CopyTo(radii);
    }
}
