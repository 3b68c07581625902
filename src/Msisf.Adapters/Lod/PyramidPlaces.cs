using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Terrain;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Lod;

/// <summary>
/// The possible places of a model's sidecar: beside the model, or, if that folder can't be written to, in the user's cache.
/// </summary>
/// <param name="Beside">Beside the model.</param>
/// <param name="Cached">In the cache, under a name of the model's own place; null without a cache.</param>
public sealed record PyramidPlaces(string Beside, string? Cached)
{
    private const string Extension = ".pyramid";

    /// <summary>The places for a model.</summary>
    /// <param name="set">The model.</param>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    public static PyramidPlaces Of(LdemSet set, string? cacheFolder)
    {
        string beside = set.FileBeside(Extension);
        string place = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(Path.GetFullPath(beside))).AsSpan(0, 8));
        return new PyramidPlaces(beside, cacheFolder is null ? null : Path.Combine(cacheFolder, $"{set.ProductId}-{place}{Extension}"));
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
