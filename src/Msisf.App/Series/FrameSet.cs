using System.Globalization;
using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.Core.Errors;
using Msisf.Core.Scene;

namespace Msisf.App.Series;

/// <summary>The frames that a folder of outputs is to hold, and how they stand. Immutable.</summary>
internal sealed class FrameSet
{
    private readonly string _folder;
    private readonly FrameCheck[] _judgements;

    private FrameSet(string folder, FrameCheck[] judgements)
    {
        _folder = folder;
        _judgements = judgements;
    }

    /// <summary>How many frames there are to be.</summary>
    public int Count => _judgements.Length;

    /// <summary>How many frames stand so.</summary>
    public int CountOf(FrameState state) => _judgements.Count(judgement => judgement.State == state);

    /// <summary>Looks at a folder.</summary>
    /// <param name="folder">Of the outputs.</param>
    /// <param name="depth">How closely.</param>
    /// <param name="structure">Looks into files, too; may be null.</param>
    /// <param name="log">Gets warnings.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="MsisfException">There is no folder, or no manifest of a run in it.</exception>
    public static FrameSet Read(string folder, CheckDepth depth, FileStructure? structure, ILog log, CancellationToken cancellation)
    {
        ManifestContent content = Content(folder, log);
        FrameChecker checker = new(folder, depth, structure);
        return new FrameSet(folder, [.. content.Expected.Values
            .OrderBy(expected => expected.Run == content.LastRun ? 1 : 0)
            .ThenBy(expected => expected.Run, StringComparer.Ordinal)
            .ThenBy(expected => expected.Step)
            .ToArray()
            .AsParallel().AsOrdered().WithCancellation(cancellation)
            .Select(expected => checker.Check(
                expected, content.Frames.GetValueOrDefault(expected.Name), content.Failed.GetValueOrDefault(expected.Name)))]);
    }

    /// <summary>What the manifest of a folder says.</summary>
    /// <inheritdoc cref="Read"/>
    public static ManifestContent Content(string folder, ILog log)
    {
        if (!Directory.Exists(folder))
        {
            throw new BadInputException($"{folder}: there is no such folder. Name the --output-dir of a run.");
        }

        ManifestFile manifest = new(folder);
        using ManifestReader reader = new(manifest);
        reader.Refresh();
        if (reader.Content.DamagedLines > 0)
        {
            log.Warning($"{manifest.FilePath}: {reader.Content.DamagedLines} lines can't be read and are left out.");
        }

        return reader.Content.Expected.Count > 0
            ? reader.Content
            : throw new BadInputException($"{manifest.FilePath}: {(File.Exists(manifest.FilePath) ? "no run is in it" : "missing")}. "
                + $"Name the --output-dir of a run.");
    }

    /// <summary>Prints a line for each frame that is not right (step, name, state, reason; separated by tabs), and a summary.</summary>
    public void Print(TextWriter results)
    {
        foreach (FrameCheck judgement in _judgements.Where(judgement => judgement.State != FrameState.Complete))
        {
            ExpectedRecord frame = judgement.Expected;
            results.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{frame.Step}\t{frame.Name}\t{Word(judgement.State)}\t{judgement.Reason.ReplaceLineEndings(" ")}"));
        }

        IEnumerable<string> others = Enum.GetValues<FrameState>().Where(state => state != FrameState.Complete && CountOf(state) > 0)
            .Select(state => string.Create(CultureInfo.InvariantCulture, $", {CountOf(state)} {Word(state)}"));
        results.WriteLine(
            string.Create(
                CultureInfo.InvariantCulture,
                $"{Count} frame{(Count == 1 ? string.Empty : "s")}: {CountOf(FrameState.Complete)} right{string.Concat(others)}."));
    }

    /// <summary>The frames of a run that are right, in the order of their steps.</summary>
    public IEnumerable<ExpectedRecord> RightSteps(string? run) =>
        _judgements.Where(
            judgement => judgement.State == FrameState.Complete && judgement.Expected.Run == run).Select(judgement => judgement.Expected);

    /// <summary>The steps that are to be made again.</summary>
    /// <exception cref="BadInputException">They belong to several runs, so that their numbers do not say which they are.</exception>
    public StepRanges StepsToMake()
    {
        ExpectedRecord[] wrong = [.. _judgements.Where(
            judgement => judgement.State != FrameState.Complete).Select(judgement => judgement.Expected)];
        return wrong.Select(frame => frame.Run).Distinct().Count() <= 1
            ? StepRanges.Of(wrong.Select(frame => frame.Step))
            : throw new BadInputException(
                $"{_folder}: frames of several runs are not right; step numbers do not say which they are. "
                    + $"Run msis status without --print-frames, or give each run a folder of its own.");
    }

    private static string Word(FrameState state) => state switch
    {
        FrameState.Missing => "missing",
        FrameState.Damaged => "damaged",
        FrameState.OtherSettings => "of other settings",
        FrameState.Failed => "failed",
        _ => "right",
    };
}
