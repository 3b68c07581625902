using System.Diagnostics;
using Msisf.Core.Errors;
using Msisf.Stress.Cluster;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Stress.Tests.Cluster;

public sealed class SlurmClusterTests
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(1);

    [RequiresFact(Part.Slurm)]
    public void Start_OnThisMachine_RunsAJobOnEachNode()
    {
        using TemporaryFolder folder = new();
        using SlurmCluster cluster = new();

        cluster.Call(
            "sbatch",
            "--nodes=1",
            "--array=0-1",
            "--exclusive",
            $"--output={folder["node %a.txt"]}",
            "--wrap=echo $SLURMD_NODENAME; sleep 1");
        cluster.WaitForJobs(Limit);

        Assert.Equal(["n1", "n2"], Enumerable.Range(0, 2).Select(task => File.ReadAllText(folder[$"node {task}.txt"]).Trim()).Order());
    }

    [RequiresFact(Part.Slurm)]
    public async Task KillNode_TaskRuns_RunsAgain()
    {
        using TemporaryFolder folder = new();
        using SlurmCluster cluster = new();
        string report = folder["report.txt"];
        cluster.Call(
            "sbatch",
            "--requeue",
            "--nodelist=n1",
            "--open-mode=append",
            $"--output={report}",
            "--wrap=echo $SLURMD_NODENAME; [ -n \"$SLURM_RESTART_COUNT\" ] || sleep 600");
        await Within.Seconds(60, "the task's line in its report", () => File.Exists(report) && new FileInfo(report).Length > 0);
        cluster.KillNode("n1");
        cluster.WaitForLoss("n1", Limit);
        cluster.StartNode("n1");
        cluster.WaitForJobs(Limit);

        Assert.Equal(["n1", "n1"], File.ReadAllLines(report));
    }

    [RequiresFact(Part.Slurm)]
    public void Dispose_JobRuns_NothingStays()
    {
        string configuration;
        using (SlurmCluster cluster = new())
        {
            configuration = cluster.Environment["SLURM_CONF"];
            cluster.Call("sbatch", "--output=/dev/null", "--wrap=sleep 600");
            cluster.WaitForTask(Limit);
        }

        Assert.False(Directory.Exists(Path.GetDirectoryName(configuration)));
        Assert.DoesNotContain(
            Process.GetProcesses(),
            process => CommandOf(process).Contains(Path.GetDirectoryName(configuration)!, StringComparison.Ordinal));
    }

    private static string CommandOf(Process process)
    {
        using (process)
        {
            try
            {
                return File.ReadAllText($"/proc/{process.Id}/environ");
            }
            catch (Exception exception) when (exception.IsFileError())
            {
                return string.Empty; // it has ended, or is another user's
            }
        }
    }
}
