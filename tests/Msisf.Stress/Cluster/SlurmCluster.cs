using System.Diagnostics;
using System.Security.Cryptography;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>
/// Slurm with two nodes on this machine, in a folder of its own, as whoever runs the test. Its daemons can be killed and started again.
/// At the end nothing of it stays.
/// </summary>
public sealed class SlurmCluster : IDisposable
{
    /// <summary>slurmd's child that keeps one task. It hides its environment, but writes to slurmd's log.</summary>
    private const string StepDaemon = "slurmstepd";

    private static readonly string[] Programs = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel", "sinfo"];
    private static readonly TimeSpan StartLimit = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan CallLimit = TimeSpan.FromSeconds(60);
    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(100);

    private readonly string _folder = Directory.CreateTempSubdirectory("msisf-slurm-").FullName;
    private readonly Dictionary<string, Daemon> _nodes = [];
    private Daemon? _munge;
    private Daemon? _controller;

    /// <summary>Starts it and waits until its nodes are idle.</summary>
    /// <exception cref="InvalidOperationException">They do not get so; the message has the ends of the logs.</exception>
    public SlurmCluster()
    {
        try
        {
            Start();
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    /// <summary>What of Slurm is not installed; null if nothing is missing.</summary>
    public static string? MissingPart =>
        Programs.FirstOrDefault(program => FileOf(program) is null) is string missing ? $"Slurm ({missing})" : null;

    /// <summary>By which Slurm's commands find this cluster.</summary>
    public IReadOnlyDictionary<string, string> Environment => new Dictionary<string, string> { ["SLURM_CONF"] = Configuration };

    private string Configuration => Path.Combine(_folder, "slurm.conf");

    private string MungeSocket => Path.Combine(_folder, "munge", "socket");

    /// <summary>Calls one of Slurm's commands and has its standard output.</summary>
    /// <exception cref="InvalidOperationException">It fails; the message has what it said.</exception>
    public string Call(string command, params IReadOnlyList<string> arguments) => Run(command, arguments).Succeeded().Output;

    /// <summary>Whether jobs run or wait.</summary>
    public bool HasJobs => !string.IsNullOrWhiteSpace(Call("squeue", "-h"));

    /// <summary>Whether a task runs.</summary>
    public bool HasTask => StepDaemons().Count > 0;

    /// <summary>Waits until no job runs or waits.</summary>
    /// <exception cref="TimeoutException">There are still some; the message names them and has the ends of the logs.</exception>
    public void WaitForJobs(TimeSpan limit) => Wait(limit, () => !HasJobs, () => $"jobs are left: {Call("squeue", "-h")}");

    /// <summary>Waits until a task runs.</summary>
    /// <exception cref="TimeoutException">None does.</exception>
    public void WaitForTask(TimeSpan limit) => Wait(limit, () => HasTask, () => $"no task runs: {Call("squeue", "-h")}");

    /// <summary>Kills the keeper of one of the running tasks; the task itself goes on.</summary>
    /// <returns>Whether there was one.</returns>
    public bool TryKillStepDaemon(CaseRandom random)
    {
        IReadOnlyList<int> daemons = StepDaemons();
        return daemons.Count > 0 && ProcessTable.Kill(daemons[random.Below(daemons.Count)]);
    }

    /// <summary>All of a node ends at once: its slurmd, its tasks, and what these have started.</summary>
    public void KillNode(string node)
    {
        // The tasks last: their keepers would report them.
        int[] tasks = [.. Tasks().Intersect(ProcessTable.WithEnvironment($"SLURMD_NODENAME={node}"))];
        ProcessTable.Kill(_nodes[node].Id);
        KillAll(StepDaemonsOf(node));
        KillAll(tasks);
        _nodes[node].Dispose();
        _nodes.Remove(node);
    }

    /// <summary>Starts a node, also again.</summary>
    public void StartNode(string node) =>
        _nodes.Add(node, new Daemon(OutputOf($"slurmd-{node}"), Environment, FileOf("slurmd")!, "-D", "-N", node));

    /// <summary>Waits until slurmctld has missed a node.</summary>
    /// <exception cref="TimeoutException">It does not.</exception>
    public void WaitForLoss(string node, TimeSpan limit)
    {
        // "down", or another state with a star: a node that still holds a job, or was taken out of service, keeps its state.
        string State() => Call("sinfo", "-h", "-n", node, "-o", "%T").Trim();
        bool IsMissed(string state) => state.Contains("down", StringComparison.Ordinal) || state.EndsWith('*');
        Wait(limit, () => IsMissed(State()), () => $"{node} is not missed: {State()}");
    }

    /// <summary>Kills slurmctld.</summary>
    public void KillController()
    {
        _controller!.Kill();
        _controller = null;
    }

    /// <summary>Starts slurmctld, also again: with the jobs that it saved.</summary>
    public void StartController() => _controller = new Daemon(OutputOf("slurmctld"), Environment, FileOf("slurmctld")!, "-D");

    /// <summary>
    /// What an administrator does after slurmctld was killed. It saves jobs every 5 s only: of one that began since then it does not know
    /// that it did, starts it a second time, is refused by the node, and then takes the node out of service and holds the job.
    /// </summary>
    public void Readmit()
    {
        WaitForController();
        foreach (string node in SlurmConfiguration.Nodes.Where(
            node => Call("sinfo", "-h", "-n", node, "-o", "%T").Contains("drain", StringComparison.Ordinal)))
        {
            Call("scontrol", "update", $"NodeName={node}", "State=RESUME");
        }

        foreach (string job in Call("squeue", "-h", "-r", "-o", "%i %r").Split('\n').Where(
            line => line.Contains("held", StringComparison.OrdinalIgnoreCase)))
        {
            Call("scontrol", "release", job.Split(' ')[0]);
        }
    }

    /// <summary>Ends all jobs and daemons and removes the folder.</summary>
    public void Dispose()
    {
        foreach (Daemon node in _nodes.Values)
        {
            node.Dispose();
        }

        _controller?.Dispose();
        _munge?.Dispose();
        KillAll(StepDaemons());
        KillAll(Tasks());
        Directory.Delete(_folder, recursive: true);
    }

    private static string? FileOf(string program) =>
        TestParts.Program(program) ?? (File.Exists($"/usr/sbin/{program}") ? $"/usr/sbin/{program}" : null); // not on every user's PATH

    private void Start()
    {
        foreach (string name in (string[])["munge", "state", "spool", "log", .. SlurmConfiguration.Nodes.Select(node => $"spool/{node}")])
        {
            Directory.CreateDirectory(Path.Combine(_folder, name));
        }

        File.WriteAllText(Configuration, SlurmConfiguration.Text(_folder, MungeSocket));
        string key = Path.Combine(_folder, "munge", "key");
        File.WriteAllBytes(key, RandomNumberGenerator.GetBytes(128));
        if (OperatingSystem.IsLinux())
        {
            // munged refuses a key that others can read, and a socket that they can't reach.
            File.SetUnixFileMode(key, UnixFileMode.UserRead | UnixFileMode.UserWrite);
            File.SetUnixFileMode(_folder, File.GetUnixFileMode(_folder) | UnixFileMode.GroupExecute | UnixFileMode.OtherExecute);
        }

        _munge = new Daemon(
            OutputOf("munged"), Environment, FileOf("munged")!, "--foreground", $"--key-file={key}", $"--socket={MungeSocket}",
            $"--pid-file={_folder}/munge/pid", $"--seed-file={_folder}/munge/seed", $"--log-file={_folder}/munge/log");
        Wait(StartLimit, () => File.Exists(MungeSocket), () => "munged does not listen");
        StartController();
        foreach (string node in SlurmConfiguration.Nodes)
        {
            StartNode(node);
        }

        WaitForController();
        Wait(
            StartLimit,
            () => Call("sinfo", "-h", "-N", "-o", "%T").Split('\n', StringSplitOptions.RemoveEmptyEntries).All(state => state == "idle"),
            () => $"the nodes are not idle: {Call("sinfo", "-h", "-N", "-o", "%N %T %E")}");
    }

    private void WaitForController() => Wait(
        StartLimit, () => Run("scontrol", ["ping"]).Output.Contains(" is UP", StringComparison.Ordinal), () => "slurmctld does not answer");

    private ChildRun Run(string command, IReadOnlyList<string> arguments)
    {
        using RunningProgram program = RunningProgram.Start(FileOf(command)!, arguments, _folder, environment: Environment);
        return program.End(CallLimit);
    }

    private IReadOnlyList<int> StepDaemons() => [.. SlurmConfiguration.Nodes.SelectMany(StepDaemonsOf)];

    private IReadOnlyList<int> StepDaemonsOf(string node) => ProcessTable.Holding(StepDaemon, SlurmConfiguration.LogOf(_folder, node));

    private IReadOnlyList<int> Tasks() => ProcessTable.WithEnvironment($"SLURM_CONF={Configuration}");

    private static void KillAll(IEnumerable<int> processes)
    {
        foreach (int process in processes)
        {
            ProcessTable.Kill(process);
        }
    }

    private string OutputOf(string daemon) => Path.Combine(_folder, "log", $"{daemon}.out");

    private void Wait(TimeSpan limit, Func<bool> isThere, Func<string> what)
    {
        Stopwatch watch = Stopwatch.StartNew();
        while (!isThere())
        {
            if (watch.Elapsed > limit)
            {
                throw new TimeoutException($"Slurm: after {limit} {what()}\n{LogEnds()}");
            }

            Thread.Sleep(Look);
        }
    }

    private string LogEnds() =>
        string.Join('\n', Directory.EnumerateFiles(Path.Combine(_folder, "log"), "*.out").Order(StringComparer.Ordinal).Select(
        log => $"{Path.GetFileName(log)}:\n{string.Join('\n', File.ReadLines(log).TakeLast(10))}"));
}
