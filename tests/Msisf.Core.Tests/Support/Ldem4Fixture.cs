using Msisf.Core.Terrain;
using Msisf.Core.Tiles.Selection;

namespace Msisf.Core.Tests.Support;

/// <summary>The real model, the selection of its tiles and its facets, made once for all tests that are handed it.</summary>
public sealed class Ldem4Fixture
{
    private readonly Lazy<MemoryElevationGrid> _grid = new(MemoryElevationGrid.Ldem4);
    private readonly Lazy<Dspsa> _selection;
    private readonly Lazy<BruteForceMoon> _moon;

    public Ldem4Fixture()
    {
        _selection = new Lazy<Dspsa>(() => new Dspsa(_grid.Value));
        _moon = new Lazy<BruteForceMoon>(() => new BruteForceMoon(_grid.Value));
    }

    public IGlobalGrid Grid => _grid.Value;

    public Dspsa Selection => _selection.Value;

    internal BruteForceMoon Moon => _moon.Value;
}
