using System.Runtime.InteropServices;
using Msisf.App.Serving;

namespace Msisf.Server;

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

    /// <summary>Listens no longer.</summary>
    public void Dispose() => Array.ForEach(_signals, signal => signal.Dispose());
}
