using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Series;

/// <summary>
/// Protects the finished frames of a series from a run with other settings that would write files of the same names, and files that no run
/// has recorded from every run.
/// </summary>
internal static class ReplacedFrames
{
    private const int NamedFiles = 3;

    /// <summary>
    /// Refuses a run that would replace finished frames of a series. A single image may be replaced, because that is how one looks for
    /// the right view; a note says what has changed.
    /// </summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <param name="plan">The run, which the manifest does not have yet.</param>
    /// <exception cref="UsageException">Finished frames of a series would be replaced; the message says what differs.</exception>
    public static void Refuse(string folder, RunPlan plan, ManifestContent known, ILog log)
    {
        if (known.Frames.Count == 0)
        {
            return;
        }

        (FrameRecord Made, SettingsRecord Wanted)[] replaced = [.. plan.Frames
            .Where(planned =>
                known.Frames.TryGetValue(planned.Frame.Name, out FrameRecord? made) && made.Frame != planned.Frame.Frame)
            .Select(planned => (known.Frames[planned.Frame.Name], planned.Settings))
            .Where(pair => pair.Item1.Files.Any(file => File.Exists(Path.Combine(folder, file.Name))))];
        string reasons = string.Join("; and ", replaced
            .GroupBy(pair => SettingsDifference.Reason(known.Settings.GetValueOrDefault(pair.Made.Settings), pair.Wanted))
            .Select(group => Invariant($"{Frames(group.Count())} {group.Key}")));
        if (replaced.Length == 0)
        {
            return;
        }

        if (replaced.All(pair => IsOfSingleImage(pair.Made, known)))
        {
            log.Note($"Replaced: {reasons}. To keep both, use another --output-name or --output-dir.");
            return;
        }

        throw new UsageException(
            $"{folder}: finished frames would be replaced: {reasons}. "
                + $"Use --overwrite to replace them, or another --output-dir to keep them.").About(OutputOptions.Folder);
    }

    /// <summary>
    /// Refuses a run that would replace, or take away, files that the manifest does not have: a user's own, or those of a folder without
    /// its manifest.
    /// </summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <param name="plan">The run, which the manifest does not have yet.</param>
    /// <exception cref="UsageException">There are such files.</exception>
    public static void RefuseUnrecorded(string folder, RunPlan plan, ManifestContent known)
    {
        HashSet<string> names = [.. plan.Frames.Select(planned => planned.Frame.Name)];
        string[] files = [.. StrayFile.In(folder, known)
            .Select(file => file.Name)
            .Where(file => ProductTable.FramesOf(file).Any(names.Contains))];
        if (files.Length > 0)
        {
            string others = files.Length > NamedFiles ? $" and {files.Length - NamedFiles} more" : string.Empty;
            throw new UsageException(
                $"{folder}: files would be replaced that no run has recorded there: {string.Join(", ", files.Take(NamedFiles))}{others}. "
                    + $"Use --overwrite to replace them, or another --output-dir to keep them.").About(OutputOptions.Folder);
        }
    }

    private static string Frames(int count) =>
        count == 1 ? "1 frame" : Invariant($"{count} frames");

    /// <summary>Whether the run that has the frame has no other.</summary>
    private static bool IsOfSingleImage(FrameRecord made, ManifestContent known) =>
        known.Expected.TryGetValue(made.Name, out ExpectedRecord? expected)
        && known.Runs.TryGetValue(expected.Run, out RunRecord? run)
        && run.Frames == 1;
}

/// <summary>A file in a folder of outputs that no record of the manifest names.</summary>
/// <param name="Name">Without folder.</param>
/// <param name="IsLeftOver">
/// Whether it has the name of a frame's file, so that it passes for a part of a frame that it does not belong to.
/// </param>
/// <param name="Reason">What is known of it, in words.</param>
internal sealed record StrayFile(string Name, bool IsLeftOver, string Reason)
{
    private const string Unknown = "no record names it";

    private const string OfOtherSettings = "the record of its frame does not name it: the frame was made with other options before, or "
        + "in another folder";

    private const string WithoutRecord = "this folder has no record of its frame; if the frame was made in another folder, msis merge "
        + "with --to copies it with its record";

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
                .Select(name => Of(name, manifest)),
        ];
    }

    private static StrayFile Of(string name, ManifestContent manifest)
    {
        string[] frames =
            ProductTable.IsMadeLater(name) ? [] : [.. ProductTable.FramesOf(name).Where(frame => IsFrame(frame, manifest))];
        return frames.Length == 0 ? new StrayFile(name, IsLeftOver: false, Unknown)
            : new StrayFile(name, IsLeftOver: true, frames.Any(manifest.Frames.ContainsKey) ? OfOtherSettings : WithoutRecord);
    }

    private static bool IsFrame(string name, ManifestContent manifest) =>
        manifest.Frames.ContainsKey(name) || manifest.Expected.ContainsKey(name);
}
