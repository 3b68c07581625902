using Msisf.Core.Terrain;
using Msisf.TestSupport;

namespace Msisf.Core.Tests.Support;

/// <summary>The mountains of <see cref="FunctionGrid.Rugged"/> at 4 px/deg, computed once and then read from memory.</summary>
public sealed class RuggedTerrain
{
    private const int PixelsPerDegree = 4;

    public RuggedTerrain()
    {
        FunctionGrid function = FunctionGrid.Rugged(PixelsPerDegree);
        double[] radius = new double[1];
        Grid = new MemoryElevationGrid("RUGGED_4", PixelsPerDegree, (line, sample) =>
        {
            function.ReadRadii(line, sample, radius);
            return radius[0];
        });
        Summary = ElevationSummary.Build(Grid);
    }

    public IElevationGrid Grid { get; }

    public ElevationSummary Summary { get; }
}
