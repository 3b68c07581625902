using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.Core.Errors;

namespace Msisf.App.Series;

/// <summary>Finds and reads the manifest of a folder that should hold one.</summary>
internal static class SeriesManifest
{
    /// <summary>The manifest of a folder.</summary>
    /// <param name="folder">Of the outputs.</param>
    /// <exception cref="BadInputException">There is no folder, or no manifest in it.</exception>
    public static ManifestFile Find(string folder)
    {
        if (!Directory.Exists(folder))
        {
            throw new BadInputException($"{folder}: there is no such folder. Name the --output-dir of a run.");
        }

        ManifestFile manifest = new(folder);
        return File.Exists(manifest.FilePath)
            ? manifest
            : throw new BadInputException($"{manifest.FilePath}: missing. Name the --output-dir of a run.");
    }

    /// <summary>What the manifest of a folder says.</summary>
    /// <inheritdoc cref="Read(ManifestFile, ILog)"/>
    public static ManifestContent Read(string folder, ILog log) => Read(Find(folder), log);

    /// <summary>What a manifest says.</summary>
    /// <exception cref="MsisfException">No run is in it, or it can't be read.</exception>
    public static ManifestContent Read(ManifestFile manifest, ILog log)
    {
        using ManifestReader reader = new(manifest);
        reader.Refresh();
        if (reader.Content.DamagedLines > 0)
        {
            log.Warning($"{manifest.FilePath}: {reader.Content.DamagedLines} lines can't be read and are left out.");
        }

        return reader.Content.Expected.Count > 0
            ? reader.Content
            : throw new BadInputException($"{manifest.FilePath}: no run is in it. Name the --output-dir of a run.");
    }
}
