using Msisf.Core.Render.Tracing;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;

namespace Msisf.Stress.Camera;

/// <summary>A model at 4 px/deg, its tracer, and what judges it: the vertices one by one, and rays against every facet.</summary>
internal sealed class TerrainUnderTest
{
    private TerrainUnderTest(IElevationGrid grid)
    {
        Grid = grid;
        Tracer = new TerrainTracer(grid);
        Vertices = new LatticeVertices(grid);
        Moon = new BruteForceMoon(grid);
    }

    public IElevationGrid Grid { get; }

    public TerrainTracer Tracer { get; }

    public LatticeVertices Vertices { get; }

    public BruteForceMoon Moon { get; }

    /// <summary>The real LDEM_4 where it is; the mountains of <see cref="FunctionGrid.Rugged"/> elsewhere.</summary>
    public static TerrainUnderTest Make() =>
        new(TestParts.Ldem4Label is null ? MemoryElevationGrid.Of(FunctionGrid.Rugged(4)) : MemoryElevationGrid.Ldem4());

    /// <summary>The facet as the program numbers it.</summary>
    public static FacetId FacetOf(BruteForceMoon.FacetId facet) => new(facet.Row - 1, facet.Column, (FacetHalf)facet.Half);
}
