using System.Globalization;
using Msisf.Adapters.Lod;
using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>What is told, and opened, with an elevation model.</summary>
internal static class ModelOpening
{
    /// <summary>Tells the user which model is drawn.</summary>
    public static void Tell(LdemSet set, ILog log)
    {
        log.Note(set.IsSynthetic
            ? $"Elevation: {set.ProductId}, a SYNTHETIC model, not the real {set.Body.Name} ({set.Description})."
            : $"Elevation: {set.ProductId} ({set.Description}).");
        if (set.Parts[0].Offset != set.ReferenceRadius)
        {
            log.Note(string.Create(
                CultureInfo.InvariantCulture,
                $"Its heights are over a sphere of {set.Parts[0].Offset / 1000.0:R} km; they are turned into heights over "
                    + $"{MoonConstants.ReferenceRadius / 1000.0:R} km."));
        }
    }

    /// <summary>Opens the levels of a model of the whole Moon, with those that are stored beside it.</summary>
    /// <param name="image">The model.</param>
    /// <param name="isSparing">Use less memory at the cost of time.</param>
    /// <param name="host">Knows the cache, and receives warnings.</param>
    public static ModelLevels OpenLevels(LdemImage image, bool isSparing, ProgramHost host)
    {
        ModelLevels levels = ModelLevels.Open(
            image,
            CacheFolder.Of(host),
            samplesBetweenReleases: isSparing ? LodLevels.SparingSamplesBetweenReleases : LodLevels.DefaultSamplesBetweenReleases);
        if (levels.Warning is not null)
        {
            host.Log.Warning(levels.Warning);
        }

        return levels;
    }
}
