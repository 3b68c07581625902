using System.Runtime.InteropServices;
using Msisf.App.Host;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>Makes the host of the server's program.</summary>
internal static class ServerHost
{
    /// <param name="log">Receives messages; those about a request go to its answer too.</param>
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

/// <summary>Waits for what ends a server: a signal, or the end of its input. A second signal is passed on.</summary>
internal sealed class EndOfServer : IDisposable
{
    private readonly TaskCompletionSource _end = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly PosixSignalRegistration[] _signals;

    /// <summary>Listens for signals.</summary>
    /// <param name="onSecond">Called at each signal after the first one.</param>
    public EndOfServer(Action onSecond) => _signals =
    [
        .. new[] { PosixSignal.SIGTERM, PosixSignal.SIGINT, PosixSignal.SIGHUP }.Select(signal => PosixSignalRegistration.Create(
            signal,
            context =>
            {
                context.Cancel = true;
                if (!_end.TrySetResult())
                {
                    onSecond();
                }
            })),
    ];

    /// <summary>Waits for the first signal, or the end of the input.</summary>
    /// <param name="input">Standard input; msis closes it to end the server.</param>
    public async Task WaitAsync(TextReader input)
    {
        await Task.WhenAny(_end.Task, Starter.InputEndedAsync(input)).ConfigureAwait(false);
        _end.TrySetResult();
    }

    public void Dispose() => Array.ForEach(_signals, signal => signal.Dispose());
}
