using Msisf.Adapters.Manifest;

namespace Msisf.App.Series;

/// <summary>A file in a folder of outputs that no record of the manifest names.</summary>
/// <param name="Name">Without folder.</param>
/// <param name="IsLeftOver">
/// Whether it has the name of a frame's file, so that it passes for a part of a frame that it does not belong to.
/// </param>
internal sealed record StrayFile(string Name, bool IsLeftOver)
{
    /// <summary>The files, sorted by name. Hidden ones, which runs use while they work, do not count.</summary>
    /// <param name="folder">Folder of the outputs.</param>
    public static IReadOnlyList<StrayFile> In(string folder, ManifestContent manifest)
    {
        HashSet<string> known =
        [
            ManifestFile.Name, SeriesMerge.SheetName, SeriesMerge.VideoName,
            .. manifest.Shared.Keys,
            .. manifest.Frames.Values.SelectMany(frame => frame.Files).Select(file => file.Name),
        ];
        return
        [
            .. Directory.EnumerateFiles(folder)
                .Select(path => Path.GetFileName(path))
                .Where(name => name[0] != '.' && !known.Contains(name))
                .Order(StringComparer.Ordinal)
                .Select(name => new StrayFile(
                    name,
                    !FrameFileNames.IsMadeLater(name) && FrameFileNames.FramesOf(name).Any(frame => IsFrame(frame, manifest)))),
        ];
    }

    private static bool IsFrame(string name, ManifestContent manifest) =>
        manifest.Frames.ContainsKey(name) || manifest.Expected.ContainsKey(name);
}
