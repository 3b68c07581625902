using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>One set of frames made in one process, by GNU parallel, and by two nodes of Slurm.</summary>
public sealed class PiecesStress : IStressTest
{
    private const string Output = "frames";
    private const int Pieces = 10;

    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(5);

    /// <inheritdoc/>
    public string Name => "pieces";

    /// <inheritdoc/>
    public string Subject =>
        "An orbit of 200 frames (40 at everyday length) of 128 x 128 px by the native renderer, in one process "
            + "and in 10 pieces by the scripts of msis batchconvert: GNU parallel, and Slurm with two nodes on this machine.";

    /// <inheritdoc/>
    public string? MissingPart =>
        Msis.MissingPart ?? SlurmCluster.MissingPart ?? (TestParts.Program("parallel") is null ? "GNU parallel" : null);

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        FrameSeries series = new(length == StressLength.Full ? 200 : 40, Size: 128);
        SetJudge judge = new();
        CaseCount manifests = new();
        using TemporaryFolder one = new();
        using TemporaryFolder byParallel = new();
        using TemporaryFolder bySlurm = new();
        Msis.Run(one.Path, series.Arguments(Output)).Succeeded();
        FrameFolder undisturbed = new(one[Output]);

        ConvertedSet parallel = new(byParallel, series, "parallel", Pieces);
        judge.Judge(parallel.Frames, undisturbed, parallel.Run(), inFlight: 0, "GNU parallel");

        using SlurmCluster cluster = new();
        ConvertedSet slurm = new(bySlurm, series, "slurm", Pieces);
        slurm.Run(cluster.Environment).Succeeded();
        cluster.WaitForJobs(Limit);
        judge.Judge(
            slurm.Frames,
            undisturbed,
            new ChildRun(slurm.Result == "0" ? 0 : 1, string.Empty, slurm.Result == "0" ? string.Empty : slurm.Logs()),
            inFlight: 0,
            "Slurm");

        Merge(undisturbed);
        Merge(parallel.Frames);
        manifests.Note(!parallel.Frames.Manifest.SequenceEqual(undisturbed.Manifest), () => "GNU parallel");
        manifests.Note(!slurm.Frames.Manifest.SequenceEqual(undisturbed.Manifest), () => "Slurm");
        return new StressReport(
            Name, 2 * series.Frames, [.. judge.Figures(), manifests.ToFigure("manifests that differ after msis merge", string.Empty, 0.0)],
            []);
    }

    private static void Merge(FrameFolder frames) => Msis.Run(frames.Path, ["merge", frames.Path]).Succeeded();
}
