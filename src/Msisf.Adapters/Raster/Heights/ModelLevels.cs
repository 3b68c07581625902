using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>The levels of detail of a model: from its sidecar if there is a valid one, otherwise computed when they are read.</summary>
public sealed class ModelLevels : IDisposable
{
    private ModelLevels(LodLevels levels, PyramidFile? file, string? warning) => (Levels, Sidecar, Warning) = (levels, file, warning);

    /// <summary>The levels; don't use them after this or the model is disposed.</summary>
    public LodLevels Levels { get; }

    /// <summary>The sidecar in use; null if all levels are computed.</summary>
    public PyramidFile? Sidecar { get; }

    /// <summary>Which sidecar exists but can't be used, and why; null if there is none such.</summary>
    public string? Warning { get; }

    /// <summary>The places for the sidecar of a model.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    public static SidecarPlaces PlacesOf(LdemSet set, string? cacheFolder) => set.PlacesOf(PyramidFile.Extension, cacheFolder);

    /// <summary>Opens the levels; no sample is read.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program; null if there is none.</param>
    /// <param name="samplesBetweenReleases">Samples of the model that are read before their memory is given back.</param>
    public static ModelLevels Open(
        LdemImage image, string? cacheFolder, int samplesBetweenReleases = LodLevels.DefaultSamplesBetweenReleases)
    {
        string? warning = null;
        PyramidFile? file = PlacesOf(image.Set, cacheFolder).Read(path =>
        {
            PyramidFile? opened = PyramidFile.TryOpen(path, image, out string? problem);
            warning ??= problem is null
                ? null
                : $"{path}: {problem}; it is not used. Make it again with 'msis ldem pyramid', or delete it.";
            return opened;
        });
        LodLevels levels = LodLevels.Open(
            image, file?.Levels.Cast<IGlobalGrid>().ToArray(), LodLevels.DefaultCacheBytes, samplesBetweenReleases);
        return new ModelLevels(levels, file, file is null ? warning : null);
    }

    /// <summary>The levels of a model that has its stored ones itself.</summary>
    public static ModelLevels Of(IGlobalGrid model) =>
        new(LodLevels.Open(model, [.. model.StoredLevels.Cast<IGlobalGrid>()]), file: null, warning: null);

    /// <summary>Unmaps the sidecar; the model stays open.</summary>
    public void Dispose() => Sidecar?.Dispose();
}
