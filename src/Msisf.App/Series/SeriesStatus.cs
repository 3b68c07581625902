using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.Core.Errors;
using Msisf.Core.Scene;

namespace Msisf.App.Series;

/// <summary>The frames that a folder of outputs should hold, and the state of each. Immutable.</summary>
internal sealed class SeriesStatus
{
    private readonly string _folder;

    private SeriesStatus(string folder, IReadOnlyList<FrameCheck> frames) => (_folder, Frames) = (folder, frames);

    /// <summary>All frames, those of the last run at the end, each run's in the order of their steps.</summary>
    public IReadOnlyList<FrameCheck> Frames { get; }

    /// <summary>Those that are missing, damaged, failed or of other settings.</summary>
    public IEnumerable<FrameCheck> Incomplete => Frames.Where(frame => frame.State != FrameState.Complete);

    /// <summary>Whether all frames are complete.</summary>
    public bool IsComplete => !Incomplete.Any();

    /// <summary>Looks at a folder quickly: whether the files are there in the lengths that were written.</summary>
    /// <param name="folder">Of the outputs.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="MsisfException">There is no folder, or no manifest of a run in it.</exception>
    public static SeriesStatus Read(string folder, ProgramHost host, CancellationToken cancellation) =>
        Of(folder, SeriesManifest.Read(folder, host.Log), new FrameChecker(folder, CheckDepth.Lengths), cancellation);

    /// <summary>Reads every file of a folder: checksums, images whole, meta files valid.</summary>
    /// <inheritdoc cref="Read"/>
    public static SeriesStatus Verify(string folder, ProgramHost host, CancellationToken cancellation) => Of(
        folder,
        SeriesManifest.Read(folder, host.Log),
        new FrameChecker(folder, CheckDepth.Checksums, new FileStructure(host.Installation.MetaFileDtd)),
        cancellation);

    /// <summary>The state of the frames that a manifest expects.</summary>
    /// <param name="folder">Of the outputs.</param>
    /// <param name="manifest">What its manifest says.</param>
    /// <param name="checker">Looks at single frames.</param>
    /// <param name="cancellation">Ends the work.</param>
    public static SeriesStatus Of(string folder, ManifestContent manifest, FrameChecker checker, CancellationToken cancellation) => new(
        folder,
        [.. manifest.Expected.Values
            .OrderBy(expected => expected.Run == manifest.LastRun ? 1 : 0)
            .ThenBy(expected => expected.Run, StringComparer.Ordinal)
            .ThenBy(expected => expected.Step)
            .ToArray()
            .AsParallel().AsOrdered().WithCancellation(cancellation)
            .Select(expected => checker.Check(
                expected, manifest.Frames.GetValueOrDefault(expected.Name), manifest.Failed.GetValueOrDefault(expected.Name)))]);

    /// <summary>How many frames are in a state.</summary>
    public int CountOf(FrameState state) => Frames.Count(frame => frame.State == state);

    /// <summary>The steps that are to be made again.</summary>
    /// <exception cref="BadInputException">They belong to several runs, so that their numbers do not say which they are.</exception>
    public StepRanges StepsToMake()
    {
        ExpectedRecord[] incomplete = [.. Incomplete.Select(frame => frame.Expected)];
        return incomplete.Select(frame => frame.Run).Distinct().Count() <= 1
            ? StepRanges.Of(incomplete.Select(frame => frame.Step))
            : throw new BadInputException(
                $"{_folder}: frames of several runs are not complete; step numbers do not say which they are. "
                    + $"Run msis status without --print-frames, or give each run a folder of its own.");
    }
}
