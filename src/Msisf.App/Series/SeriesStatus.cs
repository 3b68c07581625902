using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.Core.Scene;

namespace Msisf.App.Series;

/// <summary>The frames that a folder of outputs should hold, and the state of each. Immutable.</summary>
internal sealed class SeriesStatus
{
    private readonly string _folder;

    private SeriesStatus(string folder, IReadOnlyList<FrameCheck> frames) => (_folder, Frames) = (folder, frames);

    /// <summary>Files in the folder that no record names; empty unless they were looked for.</summary>
    public IReadOnlyList<StrayFile> Strays { get; private init; } = [];

    /// <summary>What is wrong with the files that belong to all frames, a line for each that is missing or damaged.</summary>
    public IReadOnlyList<string> Problems { get; private init; } = [];

    /// <summary>All frames, grouped by run with the last run at the end, in the order of their steps.</summary>
    public IReadOnlyList<FrameCheck> Frames { get; }

    /// <summary>The frames that are missing, damaged, failed or of other settings.</summary>
    public IEnumerable<FrameCheck> Incomplete => Frames.Where(frame => frame.State != FrameState.Complete);

    /// <summary>Whether all frames are complete, and the files that belong to all of them.</summary>
    public bool IsComplete => !Incomplete.Any() && Problems.Count == 0;

    /// <summary>Checks a folder quickly: compares the existence and lengths of the files with the manifest.</summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <exception cref="MsisfException">The folder does not exist or contains no manifest of a run.</exception>
    public static SeriesStatus Read(string folder, ProgramHost host, CancellationToken cancellation) =>
        Of(folder, SeriesManifest.Read(folder, host.Log), new FrameChecker(folder, CheckDepth.Lengths), cancellation);

    /// <summary>
    /// Checks a folder by reading every file: checksums, complete images, valid meta files; and looks for files that no record names.
    /// </summary>
    /// <inheritdoc cref="Read"/>
    public static SeriesStatus Verify(string folder, ProgramHost host, CancellationToken cancellation)
    {
        ManifestContent manifest = SeriesManifest.Read(folder, host.Log);
        FrameChecker checker = new(folder, CheckDepth.Checksums, new FileStructure(host.Installation.MetaFileDtd));
        SeriesStatus status = Of(folder, manifest, checker, cancellation);
        return new SeriesStatus(folder, status.Frames) { Problems = status.Problems, Strays = StrayFile.In(folder, manifest) };
    }

    /// <summary>The state of the frames that a manifest expects.</summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <param name="manifest">Content of the folder's manifest.</param>
    /// <param name="checker">Checks single frames.</param>
    public static SeriesStatus Of(string folder, ManifestContent manifest, FrameChecker checker, CancellationToken cancellation) => new(
        folder,
        [.. manifest.Expected.Values
            .OrderBy(expected => expected.Run == manifest.LastRun ? 1 : 0)
            .ThenBy(expected => expected.Run, StringComparer.Ordinal)
            .ThenBy(expected => expected.Step)
            .ToArray()
            .AsParallel().AsOrdered().WithCancellation(cancellation)
            .Select(expected => Explained(manifest, checker.Check(
                expected, manifest.Frames.GetValueOrDefault(expected.Name), manifest.Failed.GetValueOrDefault(expected.Name))))])
    {
        Problems = [.. manifest.Shared.Values.Select(checker.ProblemWith).OfType<string>()],
    };

    public int CountOf(FrameState state) => Frames.Count(frame => frame.State == state);

    /// <exception cref="BadInputException">The steps belong to several runs, so their numbers are ambiguous.</exception>
    public StepRanges StepsToMake()
    {
        ExpectedRecord[] incomplete = [.. Incomplete.Select(frame => frame.Expected)];
        return incomplete.Select(frame => frame.Run).Distinct().Count() <= 1
            ? StepRanges.Of(incomplete.Select(frame => frame.Step).Distinct())
            : throw new BadInputException(
                $"{_folder}: frames of several runs are not complete; step numbers do not say which they are. "
                    + $"Run msis status without --print-frames, or give each run a folder of its own.");
    }

    /// <summary>The check of a frame of other settings with the settings that differ as its reason.</summary>
    private static FrameCheck Explained(ManifestContent manifest, FrameCheck check) => check.State != FrameState.OtherSettings ? check
        : check with
        {
            Reason = SettingsDifference.Reason(
                manifest.Settings.GetValueOrDefault(manifest.Frames[check.Expected.Name].Settings),
                manifest.SettingsOf(check.Expected.Run)),
        };
}

/// <summary>Finds and reads the manifest of a folder that should hold one.</summary>
internal static class SeriesManifest
{
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

    /// <inheritdoc cref="Read(ManifestFile, ILog)"/>
    public static ManifestContent Read(string folder, ILog log) => Read(Find(folder), log);

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
