using System.Diagnostics;
using Msisf.App.Host;
using Msisf.Cli;
using Msisf.Cli.Output;

namespace Msisf.Stress.Fuzz;

/// <summary>Runs a case in this process, on a watchdog.</summary>
internal static class FuzzRunner
{
    /// <summary>A call that takes longer is told to end, as by Ctrl-C: a damaged number may ask for much work.</summary>
    public static readonly TimeSpan LongestWork = TimeSpan.FromSeconds(2.0);

    /// <summary>So long a call may take to end then, on a machine that does other things too.</summary>
    public static readonly TimeSpan LongestEnd = TimeSpan.FromSeconds(60.0);

    /// <summary>Runs it.</summary>
    /// <returns>What came of it; null if it hangs, and then goes on in the background.</returns>
    public static FuzzRun? Run(FuzzCase fuzzCase)
    {
        using StringWriter output = new();
        using StringWriter error = new();
        string? Variable(string name) => name switch
        {
            "XDG_CONFIG_HOME" => Path.Combine(fuzzCase.Folder, "settings"),
            "XDG_CACHE_HOME" => Path.Combine(fuzzCase.Folder, "cache"),
            "PATH" => null,
            _ => Environment.GetEnvironmentVariable(name),
        };
        ProgramHost host = ConsoleHost.Create(
            TextWriter.Synchronized(output), error, () => new StringReader(fuzzCase.StandardInput), TimeProvider.System, Variable);
        CancellationTokenSource patience = new(LongestWork);
        long start = Stopwatch.GetTimestamp();
        Task<int> run = Task.Run(() => CommandLineProgram.RunAsync(fuzzCase.Arguments, host, patience.Token));
        bool isEnded = Task.WaitAny([run], LongestWork + LongestEnd) == 0;
        if (!isEnded)
        {
            return null;
        }

        bool wasToldToEnd = patience.IsCancellationRequested;
        patience.Dispose();
        int? exitCode = run.IsCompletedSuccessfully ? run.Result : null;
        return new FuzzRun(exitCode, wasToldToEnd, output.ToString(), error + run.Exception?.ToString(), Stopwatch.GetElapsedTime(start));
    }
}
