using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>The lowest and the highest radius of a block of samples, by reading them all.</summary>
internal static class GridBounds
{
    public static (double Minimum, double Maximum) RadiusBounds(
        this ITerrainGrid grid, int firstLine, int lines, int firstSample, int samples)
    {
        double[] radii = new double[samples];
        (double minimum, double maximum) = (double.PositiveInfinity, double.NegativeInfinity);
        for (int line = firstLine; line < firstLine + lines; line++)
        {
            grid.ReadRadii(line, firstSample, radii);
            (minimum, maximum) = (Math.Min(minimum, radii.Min()), Math.Max(maximum, radii.Max()));
        }

        return (minimum, maximum);
    }
}
