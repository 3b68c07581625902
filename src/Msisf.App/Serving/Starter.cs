using Msisf.Adapters.Interop;

namespace Msisf.App.Serving;

/// <summary>Notices that a program has gone that started this one and holds its standard input.</summary>
internal static class Starter
{
    private static readonly TimeSpan BetweenLooks = TimeSpan.FromMilliseconds(500);

    /// <summary>Ends with the input.</summary>
    /// <param name="input">Standard input; what stands there is not used.</param>
    public static Task InputEndedAsync(TextReader input)
    {
        TaskCompletionSource end = new(TaskCreationOptions.RunContinuationsAsynchronously);
        Thread reading = new(() =>
        {
            while (input.Read() >= 0)
            {
            }

            end.TrySetResult();
        })
        {
            IsBackground = true,
        };
        reading.Start();
        return end.Task;
    }

    /// <summary>
    /// Ends when the program that started this one is gone: its pipe to standard input ends, or it dies while others that it started keep
    /// the pipe open.
    /// </summary>
    /// <param name="cancellation">Ends the wait.</param>
    public static async Task GoneAsync(TextReader input, CancellationToken cancellation)
    {
        int parent = ParentProcess.Id;
        Task end = InputEndedAsync(input);
        while (!end.IsCompleted && ParentProcess.Id == parent && !cancellation.IsCancellationRequested)
        {
            await Task.WhenAny(end, Task.Delay(BetweenLooks, cancellation)).ConfigureAwait(false);
        }
    }
}
