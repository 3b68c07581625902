using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>A model some of whose samples have no data; reading one of them is an error.</summary>
internal sealed class GridWithGaps(ITerrainGrid grid, Func<int, int, bool> isGap) : ITerrainGrid
{
    public string ProductId => grid.ProductId + "_WITH_GAPS";

    public MapProjection Projection => grid.Projection;

    public int Lines => grid.Lines;

    public int Samples => grid.Samples;

    public GridWindow Window => grid.Window;

    public (double Min, double Max) RadiusLimits => grid.RadiusLimits;

    public bool MayHaveGaps => true;

    public void ReadGaps(int line, int firstSample, Span<bool> gaps)
    {
        for (int i = 0; i < gaps.Length; i++)
        {
            gaps[i] = isGap(line, firstSample + i);
        }
    }

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            if (isGap(line, firstSample + i))
            {
                throw new BadInputException($"line {line}, sample {firstSample + i}: no data.");
            }
        }

        grid.ReadRadii(line, firstSample, radii);
    }
}
