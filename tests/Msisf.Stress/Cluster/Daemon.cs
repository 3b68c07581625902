using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>
/// A program that stays until it is told to end. A shell beside it waits for the end of its own standard input and then asks the program
/// to end, so that none stays behind when the test itself is killed.
/// </summary>
internal sealed class Daemon : IDisposable
{
    private const string Guardian =
        """log=$1; shift; exec 2>>"$log"; "$@" </dev/null >>"$log" & echo $!; cat >/dev/null; kill $!; wait $!""";

    private static readonly TimeSpan EndLimit = TimeSpan.FromSeconds(10);

    private readonly System.Diagnostics.Process _guardian;

    /// <summary>Starts it.</summary>
    /// <param name="log">File that gets what it says, after what is there.</param>
    /// <param name="environment">Variables that it gets beside this process's own.</param>
    /// <param name="command">Program and arguments; it must stay in the foreground.</param>
    public Daemon(string log, IReadOnlyDictionary<string, string> environment, params string[] command)
    {
        System.Diagnostics.ProcessStartInfo start = new("/bin/sh", ["-c", Guardian, "sh", log, .. command])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            WorkingDirectory = Path.GetDirectoryName(log)!,
        };
        foreach ((string name, string value) in environment)
        {
            start.Environment[name] = value;
        }

        _guardian = System.Diagnostics.Process.Start(start)!;
        string? id = Within.Seconds(
            EndLimit.TotalSeconds, $"the start of {command[0]}", _guardian.StandardOutput.ReadLineAsync()).GetAwaiter().GetResult();
        Id = int.Parse(id!, CultureInfo.InvariantCulture);
    }

    /// <summary>Of the program's process.</summary>
    public int Id { get; }

    /// <summary>Ends it by SIGKILL; like <see cref="Dispose"/>, once.</summary>
    public void Kill()
    {
        ProcessTable.Kill(Id);
        Dispose();
    }

    /// <summary>Asks it to end and waits for that.</summary>
    public void Dispose()
    {
        _guardian.StandardInput.Close();
        if (!_guardian.WaitForExit(EndLimit))
        {
            ProcessTable.Kill(Id);
            _guardian.WaitForExit(EndLimit);
        }

        _guardian.Dispose();
    }
}
