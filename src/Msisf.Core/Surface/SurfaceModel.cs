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
        : this([new GridPatch(grid)], SeamPatch.None)
    {
    }

    /// <summary>Makes the surface of several models.</summary>
    /// <param name="parts">The models, the coarsest first; closed if that is one of the whole Moon.</param>
    /// <param name="seams">The facets between them.</param>
    public SurfaceModel(IReadOnlyList<GridPatch> parts, SeamPatch seams)
    {
        Parts = parts;
        Seams = seams;
        Patches = [.. parts, seams];
        IsClosed = parts[0].Mesh.IsClosed;
        RadiusLimits = (parts.Min(part => part.Grid.RadiusLimits.Min), parts.Max(part => part.Grid.RadiusLimits.Max));
    }

    /// <summary>The models, the coarsest first.</summary>
    public IReadOnlyList<GridPatch> Parts { get; }

    /// <summary>The models, and after them the seams: a facet's part is an index here.</summary>
    public Patch[] Patches { get; }

    /// <summary>The facets between the models.</summary>
    public SeamPatch Seams { get; }

    /// <summary>Whether the surface goes around the whole Moon, so that no ray enters the ground without meeting a facet.</summary>
    public bool IsClosed { get; }

    /// <summary>By how much invented rays change the ground's reflectance; null without any.</summary>
    public IGroundBrightness? Brightness { get; init; }

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius => Parts[0].Grid.ReferenceRadius;

    /// <summary>Minimum and maximum radius that vertices can have, m, known without reading any.</summary>
    public (double Min, double Max) RadiusLimits { get; }

    /// <summary>The surface of a terrain; nothing is read yet unless it has several models.</summary>
    public static SurfaceModel Of(ITerrain terrain) =>
        terrain is ISurfaceSource source ? source.Surface : new SurfaceModel((ITerrainGrid)terrain);

    /// <summary>The models of a terrain with all their cells, the coarsest first; nothing is read yet.</summary>
    public static IReadOnlyList<GridPatch> WholePartsOf(ITerrain terrain) =>
        terrain is ISurfaceSource source ? source.WholeParts : [new GridPatch((ITerrainGrid)terrain)];

    /// <summary>
    /// m: radius of a sphere into which no ray gets without meeting a facet, for vertices above a radius in m; 0 if the surface is not
    /// closed.
    /// </summary>
    public double SolidRadius(double minRadius) =>
        IsClosed ? (minRadius * Patches.Min(patch => patch.Sagitta)) - Tolerances.VertexLattice : 0.0;

    /// <summary>The corners of a facet, m, body-fixed, counter-clockwise seen from outside.</summary>
    public (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet) => Patches[facet.Part].CornersOf(facet);

    public bool Has(FacetId facet) => facet.Part >= 0 && facet.Part < Patches.Length && Patches[facet.Part].Has(facet);
}
