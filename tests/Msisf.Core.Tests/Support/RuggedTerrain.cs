using Msisf.Core.Terrain;
using Msisf.TestSupport;

namespace Msisf.Core.Tests.Support;

/// <summary>The mountains of <see cref="FunctionGrid.Rugged"/> at 4 px/deg, computed once and then read from memory.</summary>
public sealed class RuggedTerrain
{
    public IGlobalGrid Grid { get; } = InMemory(4);

    /// <summary>The same at any resolution.</summary>
    internal static MemoryElevationGrid InMemory(int pixelsPerDegree)
    {
        FunctionGrid function = FunctionGrid.Rugged(pixelsPerDegree);
        double[] radius = new double[1];
        return new MemoryElevationGrid($"RUGGED_{pixelsPerDegree}", pixelsPerDegree, (line, sample) =>
        {
            function.ReadRadii(line, sample, radius);
            return radius[0];
        });
    }
}
