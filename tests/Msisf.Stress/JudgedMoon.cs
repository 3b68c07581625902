using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;

namespace Msisf.Stress;

/// <summary>A Moon and what judges the program's answers about it: rays against every facet.</summary>
/// <param name="Grid">The model.</param>
/// <param name="Facets">All its facets.</param>
internal sealed record JudgedMoon(IGlobalGrid Grid, BruteForceMoon Facets)
{
    private static readonly Lazy<JudgedMoon> LazyReal = new(MakeReal);

    /// <summary>The real LDEM_4 where it is; the mountains of <see cref="FunctionGrid.Rugged"/> at the same 4 px/deg elsewhere.</summary>
    public static JudgedMoon Real => LazyReal.Value;

    /// <summary>The made-up Moon with 40 km of relief at 2 px/deg: where the real one hides a little, this one hides much.</summary>
    public static JudgedMoon MadeUp()
    {
        RuggedMoon rugged = new();
        return new JudgedMoon(rugged.Grid, rugged.Moon);
    }

    private static JudgedMoon MakeReal()
    {
        IGlobalGrid grid = TestParts.Ldem4Label is null ? MemoryElevationGrid.Of(FunctionGrid.Rugged(4)) : MemoryElevationGrid.Ldem4();
        return new JudgedMoon(grid, new BruteForceMoon(grid));
    }
}
