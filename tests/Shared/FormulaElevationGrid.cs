using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>An elevation model whose heights (m over the reference radius) are a formula of line and sample.</summary>
internal sealed class FormulaElevationGrid(int pixelsPerDegree, Func<int, int, double> height) : IElevationGrid
{
    public string ProductId => "FORMULA";

    public int PixelsPerDegree => pixelsPerDegree;

    /// <summary>Highlands at height 0; on the near side one flat mare.</summary>
    public static FormulaElevationGrid HighlandsAndMare(int pixelsPerDegree) => new(
        pixelsPerDegree,
        (_, sample) => Math.Cos((sample + 0.5) / pixelsPerDegree * Math.PI / 180.0) > 0.5 ? -2500.0 : 0.0);

    /// <summary>Heights without any order, up to 300 m: the hardest case for an interpolation.</summary>
    public static FormulaElevationGrid Rough(int pixelsPerDegree) => new(
        pixelsPerDegree,
        (line, sample) => ((((line * 7919) + (sample * 104729)) % 1009) * 0.6) - 300.0);

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] = MoonConstants.ReferenceRadius + height(line, (firstSample + i) % (360 * pixelsPerDegree));
        }
    }

    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples) =>
        throw new NotSupportedException("Not needed by what is tested with formulas.");
}
