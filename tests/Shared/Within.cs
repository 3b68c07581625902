using System.Diagnostics;

namespace Msisf.TestSupport;

/// <summary>
/// Waits with a limit: a test that waits in vain fails and says for what, instead of never ending. The limits are far above what the work
/// takes on an idle machine, since other tests run at the same time.
/// </summary>
internal static class Within
{
    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(2);

    /// <summary>Waits for a task.</summary>
    /// <param name="seconds">The limit.</param>
    /// <param name="what">What is waited for; begins the message.</param>
    /// <param name="task">The task.</param>
    /// <exception cref="TimeoutException">It takes longer.</exception>
    public static async Task<T> Seconds<T>(double seconds, string what, Task<T> task)
    {
        await Seconds(seconds, what, (Task)task).ConfigureAwait(false);
        return await task.ConfigureAwait(false);
    }

    /// <inheritdoc cref="Seconds{T}(double, string, Task{T})"/>
    public static async Task Seconds(double seconds, string what, Task task)
    {
        Task limit = Task.Delay(TimeSpan.FromSeconds(seconds));
        if (await Task.WhenAny(task, limit).ConfigureAwait(false) == limit)
        {
            throw Late(seconds, what);
        }

        await task.ConfigureAwait(false);
    }

    /// <summary>Waits for something that has to be looked for, such as a file of another process.</summary>
    /// <param name="seconds">The limit.</param>
    /// <param name="what">What is waited for; begins the message.</param>
    /// <param name="isThere">Looks for it.</param>
    /// <exception cref="TimeoutException">It takes longer.</exception>
    public static async Task Seconds(double seconds, string what, Func<bool> isThere)
    {
        long start = Stopwatch.GetTimestamp();
        while (!isThere())
        {
            if (Stopwatch.GetElapsedTime(start).TotalSeconds > seconds)
            {
                throw Late(seconds, what);
            }

            await Task.Delay(PollInterval).ConfigureAwait(false);
        }
    }

    private static TimeoutException Late(double seconds, string what) =>
        new(FormattableString.Invariant($"{what}: not within {seconds} s"));
}
