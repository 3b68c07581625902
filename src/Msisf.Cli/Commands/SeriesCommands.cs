using Msisf.Adapters.Manifest;
using Msisf.App.Cluster;
using Msisf.App.Series;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary>The commands that cut a run into pieces, and look after the frames of a folder.</summary>
internal static class SeriesCommands
{
    /// <summary>Exit code if frames are missing, damaged, failed or of other settings, or files of other frames pass for theirs.</summary>
    private const int ExitNotComplete = 5;

    /// <summary><c>msis batchconvert</c>: converts a run to a script that makes it in pieces.</summary>
    public static int Convert(CommandCall call, CancellationToken cancellation)
    {
        ScriptFormat format = ScriptOptions.ReadFormat(call.Values);
        string path = ScriptOptions.ReadPath(call.Values);
        ConvertedRun converted = new RunConversion(call.Host).Convert(call.Values, call.Words, format, _ => path, cancellation);
        call.Host.Log.Note(Invariant($"{converted.FrameCount} frames in {converted.PieceCount} pieces."));
        call.Host.Results.WriteLine(converted.Script);
        if (converted.StatesFile is not null)
        {
            call.Host.Results.WriteLine(converted.StatesFile);
        }

        return 0;
    }

    /// <summary><c>msis submit</c>: submits a run to Slurm, and follows its jobs if requested.</summary>
    public static async Task<int> SubmitAsync(CommandCall call, CancellationToken cancellation)
    {
        RunSubmission submission = await RunSubmission.SubmitAsync(call.Values, call.Words, call.Host, cancellation).ConfigureAwait(false);
        if (!ScriptOptions.Wait.Read(call.Values))
        {
            return 0;
        }

        ConvertedRun run = submission.Run;
        int code = await submission.FollowAsync(cancellation).ConfigureAwait(false);
        if (code == 0)
        {
            call.Host.Log.Note($"{run.FrameCount} frames are there and complete.");
        }
        else
        {
            call.Host.Log.Error(code == ExitNotComplete
                ? $"frames are missing after all retries: {run.Script}.missing lists them, the logs in {run.Script}.logs say why."
                : Invariant($"the last job ended with exit code {code}: see the logs in {run.Script}.logs."));
        }

        return code;
    }

    /// <summary><c>msis status</c>: checks quickly whether a folder holds all frames of its runs.</summary>
    public static int Status(CommandCall call, CancellationToken cancellation) =>
        Report(call, SeriesStatus.Read(call.Values.Argument!, call.Host, cancellation));

    /// <summary><c>msis verify</c>: the same by reading every file.</summary>
    public static int Verify(CommandCall call, CancellationToken cancellation) =>
        Report(call, SeriesStatus.Verify(call.Values.Argument!, call.Host, cancellation));

    /// <summary><c>msis merge</c>: does the final work when all pieces of a run are done.</summary>
    public static async Task<int> MergeAsync(CommandCall call, CancellationToken cancellation)
    {
        (IReadOnlyList<string> sources, string folder) = FolderOptions.ReadFolders(call.Values);
        if (sources.Count > 0)
        {
            SeriesJoin.Run(sources, folder, call.Host, cancellation);
        }

        SeriesStatus status = await SeriesMerge.RunAsync(
            folder, FolderOptions.ReadMerge(call.Values), call.Host, cancellation).ConfigureAwait(false);
        if (status.IsComplete)
        {
            return 0;
        }

        call.Host.Log.Warning(
            $"{status.Incomplete.Count()} of {status.Frames.Count} frames are not complete; msis status {folder} names them.");
        return ExitNotComplete;
    }

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
            results.WriteLine($"-\t{file.Name}\t{(file.IsLeftOver ? "left over" : "unknown")}\t{file.Reason}");
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
