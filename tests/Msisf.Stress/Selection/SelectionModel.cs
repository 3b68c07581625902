using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;

namespace Msisf.Stress.Selection;

/// <summary>A Moon, its summary, and all its facets.</summary>
/// <param name="Grid">The model.</param>
/// <param name="Summary">What the selection goes by.</param>
/// <param name="Moon">What judges it.</param>
internal sealed record SelectionModel(IElevationGrid Grid, ElevationSummary Summary, BruteForceMoon Moon)
{
    /// <summary>The real LDEM_4 where it is; the mountains of <see cref="FunctionGrid.Rugged"/> at the same 4 px/deg elsewhere.</summary>
    public static SelectionModel Real()
    {
        IElevationGrid grid = TestParts.Ldem4Label is null ? MemoryElevationGrid.Of(FunctionGrid.Rugged(4)) : MemoryElevationGrid.Ldem4();
        return new SelectionModel(grid, ElevationSummary.Build(grid), new BruteForceMoon(grid));
    }

    /// <summary>The made-up Moon with 40 km of relief: where the real one hides a little, this one hides much.</summary>
    public static SelectionModel MadeUp()
    {
        RuggedMoon rugged = new();
        return new SelectionModel(rugged.Grid, rugged.Summary, rugged.Moon);
    }
}
