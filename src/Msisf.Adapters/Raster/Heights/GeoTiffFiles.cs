using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Opens each GeoTIFF of a run once: what was opened to learn its resolution is kept until the model is needed. Safe for several threads.
/// </summary>
/// <param name="libraryPath">MSISF_GDAL, or null.</param>
public sealed class GeoTiffFiles(string? libraryPath) : IDisposable
{
    private readonly ConcurrentDictionary<string, GeoTiffGrid> _kept = new(StringComparer.Ordinal);

    /// <summary>Resolution of a map.</summary>
    /// <param name="path">The file.</param>
    /// <inheritdoc cref="GeoTiffGrid.Open" path="/exception"/>
    public GridResolution ResolutionOf(string path)
    {
        GeoTiffGrid grid = Open(path);
        if (!_kept.TryAdd(Path.GetFullPath(path), grid))
        {
            grid.Dispose(); // another thread has kept it meanwhile
        }

        return grid.Projection.Resolution;
    }

    /// <summary>A map, which the caller closes.</summary>
    /// <param name="path">The file.</param>
    /// <inheritdoc cref="GeoTiffGrid.Open" path="/exception"/>
    public GeoTiffGrid Open(string path) =>
        _kept.TryRemove(Path.GetFullPath(path), out GeoTiffGrid? kept) ? kept : GeoTiffGrid.Open(path, libraryPath);

    /// <summary>Closes what was kept and not needed.</summary>
    public void Dispose()
    {
        foreach (string path in _kept.Keys)
        {
            if (_kept.TryRemove(path, out GeoTiffGrid? grid))
            {
                grid.Dispose();
            }
        }
    }
}
