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
    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(500);

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
        "48 frames by POV-Ray in 8 pieces on two nodes of Slurm, submitted by the script of msis batchconvert. In each set, at random "
            + "moments and in random order: kill -9 of a slurmstepd (its task goes on, and Slurm runs it a second time), "
            + "of a node (slurmd, slurmstepd, msis and POV-Ray at once; it comes back), and of slurmctld (restarted; "
            + "nodes and jobs that it lost track of are readmitted, and a set that it forgot is submitted again). "
            + "The job that checks has to finish the set.";

    /// <inheritdoc/>
    public string? MissingPart => Msis.MissingPart ?? SlurmCluster.MissingPart ?? (TestParts.Program("povray") is null ? "POV-Ray" : null);

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int kills = length == StressLength.Full ? 60 : 3;
        FrameSeries series = new(48, Size: 32, Patterns);
        SetJudge judge = new();
        CaseRandom random = new(seed, part: 0);
        using TemporaryFolder alone = new();
        Msis.Run(alone.Path, series.Arguments(Output)).Succeeded();
        int done = 0;
        for (int number = 1; done < kills; number++)
        {
            using TemporaryFolder folder = new();
            using SlurmCluster cluster = new();
            ConvertedSet set = new(folder, series, "slurm", Pieces);
            set.Run(cluster.Environment).Succeeded();
            Victim[] killed = [.. Enum.GetValues<Victim>().OrderBy(_ => random.Unit()).TakeWhile(
                victim => TryKill(cluster, set, victim, random))];
            string? result = Await(cluster, set, () => set.Result is not null) ? set.Result : "none";
            ChildRun last = new(
                result == "0" ? 0 : 1,
                string.Empty,
                result == "0" ? string.Empty : $"result {result}; jobs: {cluster.Call("squeue", "-h")}; {set.Logs()}");
            judge.Judge(
                set.Frames, new FrameFolder(alone[Output]), last, InFlight * killed.Length,
                string.Create(CultureInfo.InvariantCulture, $"set {number}: {string.Join(", ", killed)}"));
            done += killed.Length;
        }

        return new StressReport(Name, done, [.. judge.Figures()], []);
    }

    /// <returns>False if the set was finished before.</returns>
    private static bool TryKill(SlurmCluster cluster, ConvertedSet set, Victim victim, CaseRandom random)
    {
        Await(cluster, set, () => cluster.HasTask || set.Result is not null);
        Thread.Sleep(TimeSpan.FromSeconds(random.Between(0.0, 1.5)));
        if (set.Result is not null)
        {
            return false;
        }

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
                break;
        }

        return true;
    }

    /// <summary>
    /// Waits, and does meanwhile what people do: readmits what a killed slurmctld lost track of, and submits again what it forgot.
    /// </summary>
    /// <returns>Whether it came in time.</returns>
    private static bool Await(SlurmCluster cluster, ConvertedSet set, Func<bool> isThere)
    {
        Stopwatch watch = Stopwatch.StartNew();
        while (!isThere() && watch.Elapsed < Limit)
        {
            Thread.Sleep(Look);
            cluster.Readmit();
            if (!cluster.HasJobs && set.Result is null)
            {
                set.Run(cluster.Environment).Succeeded();
            }
        }

        return isThere();
    }
}
