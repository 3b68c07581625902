namespace Msisf.Core.Terrain;

/// <summary>
/// A whole Moon of radii on a regular latitude-longitude grid, pixel registered: line i (0 northernmost) lies at latitude
/// 90 - (i + 0.5) / res degrees, sample j (0 westernmost) at longitude (j + 0.5) / res degrees. Safe for several threads.
/// </summary>
public interface IGlobalGrid : ITerrainGrid
{
    /// <summary>Samples a degree.</summary>
    int PixelsPerDegree { get; }

    /// <inheritdoc/>
    bool ITerrain.IsWholeBody => true;

    /// <inheritdoc/>
    MapProjection ITerrainGrid.Projection => new Equirectangular(PixelsPerDegree);

    /// <inheritdoc/>
    int ITerrainGrid.Lines => 180 * PixelsPerDegree;

    /// <inheritdoc/>
    int ITerrainGrid.Samples => 360 * PixelsPerDegree;
}
