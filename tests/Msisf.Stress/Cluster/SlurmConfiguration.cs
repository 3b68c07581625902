using System.Globalization;
using System.Net;
using System.Net.Sockets;

namespace Msisf.Stress.Cluster;

/// <summary>
/// The slurm.conf of a cluster on this machine: all daemons listen on the loopback interface only, run as whoever starts them, and wait
/// as briefly as Slurm lets them.
/// </summary>
internal static class SlurmConfiguration
{
    /// <summary>Names of the nodes.</summary>
    public static IReadOnlyList<string> Nodes { get; } = ["n1", "n2"];

    /// <summary>The text, for free ports.</summary>
    /// <param name="folder">Of the cluster; without blanks, which Slurm can't quote.</param>
    /// <param name="mungeSocket">Where munged listens.</param>
    public static string Text(string folder, string mungeSocket)
    {
        int[] ports = FreePorts(Nodes.Count + 1);
        string nodes = string.Concat(Nodes.Select((node, index) => string.Create(
            CultureInfo.InvariantCulture,
            $"NodeName={node} NodeAddr=127.0.0.1 NodeHostname=localhost Port={ports[index]} CPUs=2 RealMemory=8000 State=UNKNOWN\n")));
        return string.Create(CultureInfo.InvariantCulture, $"""
            ClusterName=msisf
            SlurmctldHost=localhost(127.0.0.1)
            SlurmUser={Environment.UserName}
            SlurmdUser={Environment.UserName}
            SlurmctldPort={ports[^1]}
            # The default listens on all interfaces.
            CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
            AuthType=auth/munge
            # A job that is run again waits as long as a credential lives; 5 s is the min that is allowed.
            AuthInfo=socket={mungeSocket},cred_expire=5
            StateSaveLocation={folder}/state
            SlurmdSpoolDir={folder}/spool/%n
            SlurmctldPidFile={folder}/slurmctld.pid
            SlurmdPidFile={folder}/slurmd-%n.pid
            SlurmctldLogFile={folder}/log/slurmctld.log
            SlurmdLogFile={LogOf(folder, "%n")}
            # No control groups: they need root and systemd.
            ProctrackType=proctrack/linuxproc
            TaskPlugin=task/none
            JobacctGatherType=jobacct_gather/none
            AccountingStorageType=accounting_storage/none
            SelectType=select/cons_tres
            SelectTypeParameters=CR_CPU
            SlurmdParameters=config_overrides
            ReturnToService=2
            JobRequeue=1
            MpiDefault=none
            MailProg=/bin/true
            SchedulerType=sched/backfill
            SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0,bf_interval=1
            # A node that says nothing for 3 s is lost. Every 20th ping, one a second then, asks the nodes which jobs they have.
            SlurmdTimeout=3
            SlurmctldTimeout=3
            MessageTimeout=3
            BatchStartTimeout=1
            KillWait=1
            {nodes}PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP

            """);
    }

    /// <summary>The log of a node's slurmd.</summary>
    public static string LogOf(string folder, string node) => $"{folder}/log/slurmd-{node}.log";

    private static int[] FreePorts(int count)
    {
        TcpListener[] listeners = [.. Enumerable.Range(0, count).Select(_ => new TcpListener(IPAddress.Loopback, 0))];
        foreach (TcpListener listener in listeners)
        {
            listener.Start();
        }

        int[] ports = [.. listeners.Select(listener => ((IPEndPoint)listener.LocalEndpoint).Port)];
        foreach (TcpListener listener in listeners)
        {
            listener.Dispose();
        }

        return ports;
    }
}
