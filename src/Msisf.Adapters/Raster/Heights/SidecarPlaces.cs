using Msisf.Adapters.IO;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The possible places of a file that is derived from a model: beside the model, or, if that folder can't be written to, in the user's
/// cache.
/// </summary>
/// <param name="Beside">Beside the model.</param>
/// <param name="Cached">In the cache, under a name of the model's own place; null without a cache.</param>
public sealed record SidecarPlaces(string Beside, string? Cached)
{
    /// <summary>The places for a model.</summary>
    /// <param name="set">The model.</param>
    /// <param name="extension">Of the file, with its dot.</param>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    public static SidecarPlaces Of(LdemSet set, string extension, string? cacheFolder)
    {
        string beside = set.FileBeside(extension);
        return new SidecarPlaces(
            beside, cacheFolder is null ? null : Path.Combine(cacheFolder, $"{set.ProductId}-{PathKey.Of(beside)}{extension}"));
    }

    /// <summary>The first place whose folder takes files.</summary>
    public string ForWriting()
    {
        if (Cached is null || TakesFiles(Path.GetDirectoryName(Path.GetFullPath(Beside))!))
        {
            return Beside; // without a cache the failure of writing says why
        }

        return Cached;
    }

    private static bool TakesFiles(string folder)
    {
        try
        {
            string probe = Path.Combine(folder, Path.GetRandomFileName());
            using FileStream file = new(
                probe, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 1, FileOptions.DeleteOnClose);
            return true;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return false;
        }
    }
}
