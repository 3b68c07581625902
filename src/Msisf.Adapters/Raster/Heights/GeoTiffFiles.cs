using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Opens each raster of a run that GDAL reads once: what was opened to learn its resolution is kept until the model is needed. Safe for
/// several threads.
/// </summary>
/// <param name="libraryPath">MSISF_GDAL, or null.</param>
public sealed class GeoTiffFiles(string? libraryPath) : IDisposable
{
    private readonly ConcurrentDictionary<(string Path, HeightOptions Given), GeoTiffGrid> _kept = new();

    /// <summary>Resolution of a map.</summary>
    /// <param name="given">What the user says of its values.</param>
    /// <inheritdoc cref="GeoTiffGrid.Open" path="/exception"/>
    public GridResolution ResolutionOf(string path, HeightOptions given = default)
    {
        GeoTiffGrid grid = Open(path, given);
        if (!_kept.TryAdd(KeyOf(path, given), grid))
        {
            grid.Dispose(); // another thread has kept it meanwhile
        }

        return grid.Projection.Resolution;
    }

    /// <summary>Whether a map has a sample for each place of the Moon, be it without data.</summary>
    /// <param name="given">What the user says of its values.</param>
    /// <inheritdoc cref="GeoTiffGrid.Open" path="/exception"/>
    public bool CoversWholeMoon(string path, HeightOptions given = default)
    {
        ResolutionOf(path, given);
        return _kept.TryGetValue(KeyOf(path, given), out GeoTiffGrid? grid) && grid.CoversWholeMoon;
    }

    /// <summary>A map, which the caller closes.</summary>
    /// <param name="given">What the user says of its values.</param>
    /// <inheritdoc cref="GeoTiffGrid.Open" path="/exception"/>
    public GeoTiffGrid Open(string path, HeightOptions given = default) =>
        _kept.TryRemove(KeyOf(path, given), out GeoTiffGrid? kept) ? kept : GeoTiffGrid.Open(path, libraryPath, given);

    /// <summary>Closes what was kept and not needed.</summary>
    public void Dispose()
    {
        foreach ((string Path, HeightOptions Given) key in _kept.Keys)
        {
            if (_kept.TryRemove(key, out GeoTiffGrid? grid))
            {
                grid.Dispose();
            }
        }
    }

    private static (string Path, HeightOptions Given) KeyOf(string path, HeightOptions given) => (Path.GetFullPath(path), given);
}
