using System.Diagnostics;
using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>Kills Slurm's own daemons while a job array makes frames.</summary>
public sealed class SlurmKillStress : IStressTest
{
    private const string Output = "frames";
    private const string Patterns = "patterns";
    private const int Pieces = 8;

    /// <summary>Two nodes with two tasks each, of which each makes one frame at once.</summary>
    private const int InFlight = 4;

    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(3);

    private enum Victim
    {
        StepDaemon,
        Node,
        Controller,
    }

    /// <inheritdoc/>
    public string Name => "slurm-kills";

    /// <inheritdoc/>
    public string Subject =>
        "24 frames by POV-Ray in 8 pieces on two nodes of Slurm, submitted by the script of msis batchconvert. In each set, at random moments and in random order: kill -9 of a slurmstepd (its task goes on, and Slurm runs it a second time), of a node (slurmd, slurmstepd, msis and POV-Ray at once; it comes back), and of slurmctld (restarted; the administrator readmits nodes and jobs that it lost track of). The job that checks has to finish the set.";

    /// <inheritdoc/>
    public string? MissingPart => Msis.MissingPart ?? SlurmCluster.MissingPart ?? (TestParts.Program("povray") is null ? "POV-Ray" : null);

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int sets = length == StressLength.Full ? 20 : 1;
        FrameSeries series = new(24, Size: 32, Patterns);
        SetJudge judge = new();
        CaseRandom random = new(seed, part: 0);
        using TemporaryFolder alone = new();
        Msis.Run(alone.Path, series.Arguments(Output)).Succeeded();
        for (int number = 1; number <= sets; number++)
        {
            Victim[] victims = [.. Enum.GetValues<Victim>().OrderBy(_ => random.Unit())];
            using TemporaryFolder folder = new();
            using SlurmCluster cluster = new(); // one for each set, as a cluster has when it has long been at work
            ConvertedSet set = new(folder, series, "slurm", Pieces);
            set.Run(cluster.Environment).Succeeded();
            foreach (Victim victim in victims)
            {
                Kill(cluster, victim, random);
            }

            ChildRun last = Await(cluster, set);
            judge.Judge(
                set.Frames, new FrameFolder(alone[Output]), last, InFlight * victims.Length, string.Create(CultureInfo.InvariantCulture, $"set {number}: {string.Join(", ", victims)}"));
        }

        return new StressReport(Name, sets * Enum.GetValues<Victim>().Length, [.. judge.Figures()], []);
    }

    private static void Kill(SlurmCluster cluster, Victim victim, CaseRandom random)
    {
        cluster.WaitForTasks(1, Limit);
        Thread.Sleep(TimeSpan.FromSeconds(random.Between(0.0, 1.5)));
        switch (victim)
        {
            case Victim.StepDaemon:
                cluster.TryKillStepDaemon(random);
                break;
            case Victim.Node:
                string node = SlurmConfiguration.Nodes[random.Below(SlurmConfiguration.Nodes.Count)];
                cluster.KillNode(node);
                cluster.WaitForLoss(node, Limit);
                cluster.StartNode(node);
                break;
            default:
                cluster.KillController();
                Thread.Sleep(TimeSpan.FromSeconds(random.Unit()));
                cluster.StartController();
                cluster.Readmit();
                break;
        }
    }

    private static ChildRun Await(SlurmCluster cluster, ConvertedSet set)
    {
        Stopwatch watch = Stopwatch.StartNew();
        while (set.Result is null && watch.Elapsed < Limit)
        {
            Thread.Sleep(500);
            cluster.Readmit();
        }

        return set.Result == "0" ? new ChildRun(0, string.Empty, string.Empty) : new ChildRun(1, string.Empty, $"result {set.Result ?? "none"}; jobs: {cluster.Call("squeue", "-h")}; {set.Logs()}");
    }
}
