using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>A model, its tracer, and what judges it: the vertices one by one, and rays against every facet.</summary>
/// <param name="moon">The model.</param>
internal sealed class TerrainUnderTest(JudgedMoon moon)
{
    public IGlobalGrid Grid => moon.Grid;

    public TerrainTracer Tracer { get; } = new(moon.Grid);

    public LatticeVertices Vertices { get; } = new(moon.Grid);

    public BruteForceMoon Facets => moon.Facets;

    /// <summary>The facet to 30 digits.</summary>
    public PreciseFacet PreciseFacetOf(FacetId facet) => PreciseFacet.From(Vertices.CornersOf(facet));

    /// <summary>The facet as the program numbers it.</summary>
    public static FacetId FacetOf(BruteForceMoon.FacetId facet) => new(facet.Row - 1, facet.Column, (FacetHalf)facet.Half);
}
