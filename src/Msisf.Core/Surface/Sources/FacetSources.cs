using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>Tells of the facets of a surface where their heights come from. Safe for several threads.</summary>
public sealed class FacetSources
{
    private readonly SurfaceModel _surface;
    private readonly int _models;
    private readonly int _firstInvented;

    /// <summary>Takes a surface.</summary>
    /// <param name="terrain">What a frame shows.</param>
    public FacetSources(ITerrain terrain)
    {
        _surface = SurfaceModel.Of(terrain);
        _models = terrain.Models.Count;
        _firstInvented = terrain.FirstInventedPart ?? int.MaxValue;
    }

    /// <summary>By how much invented rays change the reflectance; null without any.</summary>
    internal IGroundBrightness? Brightness => _surface.Brightness;

    /// <summary>Where a facet's heights come from.</summary>
    /// <param name="facet">A facet of the surface.</param>
    /// <returns>Number of the model, 0 for the coarsest, of a seam that of the finest one at a corner; and the kind.</returns>
    public (int Model, FacetSource Source) Of(FacetId facet)
    {
        (int part, FacetSource source) = _surface.Patches[facet.Part].SourceOf(facet);
        bool isInvented = facet.Part >= _firstInvented && source != FacetSource.Seam;
        return (Math.Min(part, _models), isInvented ? FacetSource.Invented : source);
    }
}
