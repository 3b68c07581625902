using System.Globalization;
using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;

namespace Msisf.App.Series;

/// <summary>Protects the finished frames of a series from a run with other settings that would write files of the same names.</summary>
internal static class ReplacedFrames
{
    /// <summary>
    /// Refuses a run that would replace finished frames of a series. A single image may be replaced, because that is how one looks for
    /// the right view; a note says what has changed.
    /// </summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <param name="plan">The run, which the manifest does not have yet.</param>
    /// <param name="known">Content of the manifest.</param>
    /// <param name="log">Receives the note.</param>
    /// <exception cref="UsageException">Finished frames of a series would be replaced; the message says what differs.</exception>
    public static void Refuse(string folder, RunPlan plan, ManifestContent known, ILog log)
    {
        if (known.Frames.Count == 0)
        {
            return;
        }

        FrameRecord[] replaced = [.. plan.Frames
            .Where(expected => known.Frames.TryGetValue(expected.Name, out FrameRecord? made) && made.Frame != expected.Frame)
            .Select(expected => known.Frames[expected.Name])
            .Where(made => made.Files.Any(file => File.Exists(Path.Combine(folder, file.Name))))];
        string reasons = string.Join("; and ", replaced
            .GroupBy(made => SettingsDifference.Reason(known.Settings.GetValueOrDefault(made.Settings), plan.Identity.Record))
            .Select(group => string.Create(CultureInfo.InvariantCulture, $"{Frames(group.Count())} {group.Key}")));
        if (replaced.Length == 0)
        {
            return;
        }

        if (replaced.All(made => IsOfSingleImage(made, known)))
        {
            log.Note($"Replaced: {reasons}. To keep both, use another --output-name or --output-dir.");
            return;
        }

        throw new UsageException(
            $"{folder}: finished frames would be replaced: {reasons}. "
                + $"Use --overwrite to replace them, or another --output-dir to keep them.").About(OutputOptions.Folder);
    }

    private static string Frames(int count) =>
        count == 1 ? "1 frame" : string.Create(CultureInfo.InvariantCulture, $"{count} frames");

    /// <summary>Whether the run that has the frame has no other.</summary>
    private static bool IsOfSingleImage(FrameRecord made, ManifestContent known) =>
        known.Expected.TryGetValue(made.Name, out ExpectedRecord? expected)
        && known.Runs.TryGetValue(expected.Run, out RunRecord? run)
        && run.Frames == 1;
}
