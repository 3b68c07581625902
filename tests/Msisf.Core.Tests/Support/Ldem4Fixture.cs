using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Core.Tests.Support;

/// <summary>The real model, its summary and its facets, made once for all tests that are handed it.</summary>
public sealed class Ldem4Fixture
{
    private readonly Lazy<MemoryElevationGrid> _grid = new(MemoryElevationGrid.Ldem4);
    private readonly Lazy<ElevationSummary> _summary;
    private readonly Lazy<BruteForceMoon> _moon;

    public Ldem4Fixture()
    {
        _summary = new Lazy<ElevationSummary>(() => ElevationSummary.Build(_grid.Value));
        _moon = new Lazy<BruteForceMoon>(() => new BruteForceMoon(_grid.Value));
    }

    public IGlobalGrid Grid => _grid.Value;

    public ElevationSummary Summary => _summary.Value;

    internal BruteForceMoon Moon => _moon.Value;
}
