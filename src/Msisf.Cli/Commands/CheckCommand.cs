using Msisf.Adapters.Manifest;
using Msisf.App.Series;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary>
/// <c>msis status</c> and <c>msis verify</c>: check whether a folder holds all frames of its runs, quickly or by reading every file.
/// </summary>
internal static class CheckCommand
{
    /// <summary>Exit code if frames are missing, damaged, failed or of other settings, or files of other frames pass for theirs.</summary>
    public const int ExitNotComplete = 5;

    /// <summary>Runs <c>msis status</c>, the quick check.</summary>
    public static int Status(CommandCall call, CancellationToken cancellation) =>
        Report(call, SeriesStatus.Read(call.Values.Argument!, call.Host, cancellation));

    /// <summary>Runs <c>msis verify</c>, which reads every file.</summary>
    public static int Verify(CommandCall call, CancellationToken cancellation) =>
        Report(call, SeriesStatus.Verify(call.Values.Argument!, call.Host, cancellation));

    private static int Report(CommandCall call, SeriesStatus status)
    {
        if (FolderOptions.PrintFrames.Read(call.Values))
        {
            call.Host.Results.WriteLine(status.StepsToMake().ToString());
            return status.IsComplete ? 0 : ExitNotComplete;
        }

        Print(status, call.Host.Results);
        return status.IsComplete && !status.Strays.Any(file => file.IsLeftOver) ? 0 : ExitNotComplete;
    }

    /// <summary>
    /// Prints one line for each incomplete frame (step, name, state, reason; separated by tabs), one for each file that no record names
    /// (without a step), and a summary.
    /// </summary>
    private static void Print(SeriesStatus status, TextWriter results)
    {
        foreach (FrameCheck frame in status.Incomplete)
        {
            results.WriteLine(Invariant(
                $"{frame.Expected.Step}\t{frame.Expected.Name}\t{Word(frame.State)}\t{frame.Reason.ReplaceLineEndings(" ")}"));
        }

        foreach (string problem in status.Problems)
        {
            results.WriteLine($"-\t{problem.Replace(": ", "\tdamaged\t", StringComparison.Ordinal)}");
        }

        foreach (StrayFile file in status.Strays)
        {
            results.WriteLine(file.IsLeftOver
                ? $"-\t{file.Name}\tleft over\tit is of another frame of this name; remove it"
                : $"-\t{file.Name}\tunknown\tno record names it");
        }

        int count = status.Frames.Count;
        IEnumerable<string> others = Enum.GetValues<FrameState>().Where(state => state != FrameState.Complete && status.CountOf(state) > 0)
            .Select(state => Invariant($", {status.CountOf(state)} {Word(state)}"));
        string strays = status.Strays.Count == 0
            ? string.Empty
            : Invariant($" {status.Strays.Count} file{(status.Strays.Count == 1 ? string.Empty : "s")} that no record names.");
        results.WriteLine(Invariant(
            $"{count} frame{(count == 1 ? string.Empty : "s")}: {status.CountOf(FrameState.Complete)} complete{string.Concat(others)}.")
            + strays);
    }

    private static string Word(FrameState state) =>
        state == FrameState.OtherSettings ? "of other settings" : state.ToString().ToLowerInvariant();
}
