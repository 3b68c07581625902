using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>
/// Judges sets of frames after the run that finished them: whether they are whole, the same as undisturbed ones, and nothing else is left.
/// </summary>
internal sealed class SetJudge
{
    private readonly CaseCount _failed = new();
    private readonly CaseCount _refused = new();
    private readonly CaseCount _differing = new();
    private readonly CaseCount _left = new();
    private readonly CaseCount _again = new();

    /// <summary>Judges a set.</summary>
    /// <param name="set">Its folder, in one of its own.</param>
    /// <param name="undisturbed">The same frames, made by one process.</param>
    /// <param name="last">The run that finished it.</param>
    /// <param name="inFlight">How many frames may have been made twice, because whoever made them was killed meanwhile.</param>
    /// <param name="what">What was done to it, for the report.</param>
    public void Judge(FrameFolder set, FrameFolder undisturbed, ChildRun last, int inFlight, string what)
    {
        NoteRun(last, what);
        ChildRun verified = Msis.Run(Path.GetDirectoryName(set.Path)!, ["verify", set.Path]);
        _refused.Note(verified.ExitCode != 0, () => $"{what}: exit code {verified.ExitCode}: {OneLine(verified.Output + verified.Error)}");
        NoteDifferences(set, undisturbed, what);
        NoteLeftovers(set.Leftovers, what);
        int excess = Math.Max(0, set.FramesMade - undisturbed.FramesMade - inFlight);
        _again.Note(
            excess,
            undisturbed.FramesMade,
            () => $"{what}: {set.FramesMade} times made for {undisturbed.FramesMade} frames, {inFlight} of them in flight");
    }

    /// <summary>Notes a run that has to end well, without a line that speaks of an error.</summary>
    public void NoteRun(ChildRun run, string what) => _failed.Note(
        run.ExitCode != 0 || run.Error.Contains("error", StringComparison.OrdinalIgnoreCase), () =>
            $"{what}: exit code {run.ExitCode}: {OneLine(run.Error)}");

    /// <summary>Notes files that are not the same.</summary>
    public void NoteDifferences(FrameFolder set, FrameFolder undisturbed, string what)
    {
        IReadOnlyList<string> names = set.DifferencesFrom(undisturbed);
        _differing.Note(names.Count, undisturbed.Files, () => $"{what}: {string.Join(", ", names.Take(5))}");
    }

    /// <summary>Notes what should not be there any more.</summary>
    public void NoteLeftovers(IReadOnlyList<string> names, string what) =>
        _left.Note(names.Count > 0, () => $"{what}: {string.Join(", ", names.Take(5))}");

    /// <summary>What all sets showed.</summary>
    public IEnumerable<StressFigure> Figures() =>
    [
        _failed.ToFigure("runs that had to end well and did not", string.Empty, 0.0),
        _refused.ToFigure("sets that msis verify did not accept", string.Empty, 0.0),
        _differing.ToFigure("files that differ from those of one undisturbed process", string.Empty, 0.0),
        _left.ToFigure("sets with something left over", string.Empty, 0.0),
        _again.ToFigure("frames made again that were not in flight", string.Empty, 0.0),
    ];

    /// <summary>The end of what a program said, without line ends.</summary>
    public static string OneLine(string text) =>
        string.Join(" / ", text.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).TakeLast(3));
}
