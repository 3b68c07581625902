using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>The surface that one frame shows: the elevation models, and windows of generated ground inside each other.</summary>
public sealed class RefinedView : ITerrain, ISurfaceSource
{
    private readonly RefinedTerrain _terrain;
    private readonly Lazy<SurfaceModel> _surface;

    internal RefinedView(RefinedTerrain terrain, ITerrain models, IReadOnlyList<WindowPlace> places, Func<SurfaceModel> join)
    {
        (_terrain, Places) = (terrain, places);
        PartCount = models.PartCount + places.Count;
        FirstInventedPart = places.Count == 0 ? int.MaxValue : models.PartCount;
        DrawnResolutions =
        [
            .. models.Models.Select(model => model.Projection.Resolution),
            .. places.Select(place => GridResolution.FromMetresPerPixel(Math.ScaleB(1.0, place.Level))),
        ];
        _surface = new Lazy<SurfaceModel>(join);
    }

    /// <inheritdoc/>
    public IReadOnlyList<ITerrainGrid> Models => _terrain.Models;

    /// <inheritdoc/>
    public IReadOnlyList<GridResolution?> DrawnResolutions { get; }

    /// <inheritdoc/>
    public string ProductId => _terrain.ProductId;

    /// <inheritdoc/>
    public GridResolution Resolution => _terrain.Resolution;

    /// <inheritdoc/>
    public double ReferenceRadius => _terrain.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => _terrain.RadiusLimits;

    /// <inheritdoc/>
    public int PartCount { get; }

    /// <inheritdoc/>
    public int? FirstInventedPart { get; }

    /// <summary>Where the windows lie, the coarsest first.</summary>
    internal IReadOnlyList<WindowPlace> Places { get; }

    /// <summary>The surface; made at the first request.</summary>
    internal SurfaceModel Surface => _surface.Value;

    SurfaceModel ISurfaceSource.Surface => Surface;

    IReadOnlyList<GridPatch> ISurfaceSource.WholeParts => _terrain.WholeParts;

    /// <inheritdoc/>
    public void ReleasePages() => _terrain.ReleasePages();
}
