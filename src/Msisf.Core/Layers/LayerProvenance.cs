using Msisf.Core.Render.Photometry;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Layers;

/// <summary>Facts about a frame that the layers' files hold beyond its metadata.</summary>
/// <param name="ElevationProduct">Name of the elevation model, e.g. "LDEM_64".</param>
/// <param name="MeshResolution">
/// Resolution of the grid whose cells are counted: the model's own, or that of its level of detail.
/// </param>
/// <param name="LevelOfDetail">Level of detail; 0 is the model itself.</param>
/// <param name="Renderer">Name of the renderer, e.g. "native".</param>
/// <param name="Band">Band of the radiance.</param>
public sealed record LayerProvenance(
    string ElevationProduct, GridResolution MeshResolution, int LevelOfDetail, string Renderer, SpectralBand Band)
{
    /// <summary>Number of elevation models; with several the mesh's resolution is that of the finest, and there are no tiles.</summary>
    public int Parts { get; init; } = 1;

    /// <summary>Tells where the heights of facets come from; null if all are those of one model.</summary>
    public FacetSources? Sources { get; init; }

    /// <summary>Name of the detail that was invented below the models' resolution, e.g. "REFINE_7"; null without.</summary>
    public string? InventedDetail { get; init; }

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius { get; init; } = MoonConstants.ReferenceRadius;
}
