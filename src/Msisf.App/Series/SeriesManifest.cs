using Msisf.Adapters.Manifest;
using Msisf.App.Host;

namespace Msisf.App.Series;

/// <summary>Finds and reads the manifest of a folder that should hold one.</summary>
internal static class SeriesManifest
{
    /// <summary>Finds the manifest of a folder.</summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <exception cref="BadInputException">The folder or its manifest does not exist.</exception>
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

    /// <summary>Reads the manifest of a folder.</summary>
    /// <inheritdoc cref="Read(ManifestFile, ILog)"/>
    public static ManifestContent Read(string folder, ILog log) => Read(Find(folder), log);

    /// <summary>Reads a manifest.</summary>
    /// <exception cref="MsisfException">The manifest contains no run, or can't be read.</exception>
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
