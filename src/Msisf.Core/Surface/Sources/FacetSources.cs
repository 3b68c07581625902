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
        Patch patch = _surface.Patches[facet.Part];
        (int model, bool isBlended) = (facet.Part == _surface.Parts.Count ? 0 : facet.Part, false);
        for (int corner = 0; corner < 3; corner++)
        {
            (int part, int line, int sample) = patch.VertexOf(facet, corner);
            model = Math.Max(model, part);
            isBlended |= facet.Part < _surface.Parts.Count && _surface.Parts[part].Grid is IBlendedGrid grid
                && line >= 0 && line < grid.Lines && grid.IsBlended(line, sample);
        }

        model = Math.Min(model, _models);
        return (
            model,
            facet.Part == _surface.Parts.Count ? FacetSource.Seam
            : facet.Part >= _firstInvented ? FacetSource.Invented
            : isBlended ? FacetSource.Blended
            : FacetSource.Measured);
    }
}

/// <summary>Where the heights of a facet come from.</summary>
public enum FacetSource
{
    /// <summary>From one model, as they are there.</summary>
    Measured = 1,

    /// <summary>From one model, changed to meet others.</summary>
    Blended = 2,

    /// <summary>It joins two models.</summary>
    Seam = 3,

    /// <summary>They are invented.</summary>
    Invented = 4,
}
