using Msisf.Core.Numerics;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// The surface that is drawn and traced: the facets of one elevation model, or of several, each where no finer one has data, with seams
/// between them. The models are read only where they are needed. Safe for several threads.
/// </summary>
internal sealed class SurfaceModel
{
    /// <summary>Makes the surface of one model; nothing of the model is read yet.</summary>
    /// <param name="grid">The elevation model.</param>
    public SurfaceModel(ITerrainGrid grid)
        : this([new GridPatch(grid)], SeamMesh.None)
    {
    }

    /// <summary>Makes the surface of several models.</summary>
    /// <param name="parts">The models, the coarsest first; closed if that is one of the whole Moon.</param>
    /// <param name="seams">The facets between them.</param>
    public SurfaceModel(IReadOnlyList<GridPatch> parts, SeamMesh seams)
    {
        Parts = parts;
        Seams = seams;
        IsClosed = parts[0].Mesh.IsClosed;
        RadiusLimits = (parts.Min(part => part.Grid.RadiusLimits.Min), parts.Max(part => part.Grid.RadiusLimits.Max));
    }

    /// <summary>The models, the coarsest first.</summary>
    public IReadOnlyList<GridPatch> Parts { get; }

    /// <summary>The facets between the models.</summary>
    public SeamMesh Seams { get; }

    /// <summary>Whether the surface goes around the whole Moon, so that no ray enters the ground without meeting a facet.</summary>
    public bool IsClosed { get; }

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius => Parts[0].Grid.ReferenceRadius;

    /// <summary>Minimum and maximum radius that vertices can have, m, known without reading any.</summary>
    public (double Min, double Max) RadiusLimits { get; }

    /// <summary>The surface of a terrain; nothing is read yet unless it has several models.</summary>
    public static SurfaceModel Of(ITerrain terrain) => terrain switch
    {
        NestedTerrain nested => nested.Surface,
        RefinedView view => view.Surface,
        ITerrainGrid grid => new SurfaceModel(grid),
        _ => throw new ArgumentException($"{terrain.GetType()}: not a terrain with a surface.", nameof(terrain)),
    };

    /// <summary>
    /// m: radius of a sphere into which no ray gets without meeting a facet, for vertices above a radius in m; 0 if the surface is not
    /// closed.
    /// </summary>
    public double SolidRadius(double minRadius) => IsClosed
        ? (minRadius * Math.Min(Seams.Sagitta, Parts.Min(part => part.Geometry.Sagitta))) - Tolerances.VertexLattice
        : 0.0;

    /// <summary>The corners of a facet, m, MOON_ME, counter-clockwise seen from outside.</summary>
    public (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet) => facet.Part == Parts.Count
        ? Seams.CornersOf(facet.Sample)
        : Parts[facet.Part].Corners(facet.Line, facet.Sample).Facet(facet.Half);

    /// <summary>Whether the surface has a facet.</summary>
    public bool Has(FacetId facet)
    {
        if (facet.Part < 0 || facet.Part > Parts.Count)
        {
            return false;
        }

        if (facet.Part == Parts.Count)
        {
            return facet.Line == 0 && facet.Sample >= 0 && facet.Sample < Seams.Count && facet.Half == FacetHalf.SouthWest;
        }

        CellRange cells = Parts[facet.Part].Mesh.Cells;
        return facet.Line >= cells.FirstLine && facet.Line < cells.EndLine && facet.Sample >= cells.FirstSample
            && facet.Sample < cells.EndSample && Parts[facet.Part].Has(facet.Line, facet.Sample);
    }
}
