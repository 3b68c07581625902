using Msisf.App.Host;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>Makes the host of the server's program.</summary>
internal static class ServerHost
{
    /// <summary>Creates the host.</summary>
    /// <param name="results">Standard output.</param>
    /// <param name="log">Receives messages; those about a request go to its answer too.</param>
    /// <param name="environment">Gets a variable of the environment.</param>
    public static ProgramHost Create(TextWriter results, ILog log, TimeProvider clock, Func<string, string?> environment) =>
        new(clock, environment)
        {
            Results = results,
            Log = new RequestLog(log),
            Progress = new NoProgress(),
            StandardInput = () => TextReader.Null,
        };
}

/// <summary>Threads of the server's process.</summary>
internal static class ServerThreads
{
    /// <summary>
    /// Threads for each core: one draws a small and one a large image, up to three wait for others of each frame, and two answer. With the
    /// default of one for each core, a request may wait for seconds while frames are drawn, because further threads come one by one.
    /// </summary>
    private const int OfACore = 10;

    /// <summary>Makes as many threads as are needed at once start at once.</summary>
    public static void Reserve()
    {
        ThreadPool.GetMinThreads(out int workers, out int completions);
        ThreadPool.SetMinThreads(Math.Max(workers, OfACore * Environment.ProcessorCount), completions);
    }
}
