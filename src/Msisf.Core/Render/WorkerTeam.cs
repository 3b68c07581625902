using System.Runtime.ExceptionServices;

namespace Msisf.Core.Render;

/// <summary>Shares items of work among threads; who does which is open, so items must not depend on each other.</summary>
internal static class WorkerTeam
{
    /// <summary>Does every item once.</summary>
    /// <param name="threads">Workers at most, at least 1.</param>
    /// <param name="items">How many items.</param>
    /// <param name="work">Gets the worker (from 0) and the item; a worker does one item at a time.</param>
    /// <param name="cancellation">Ends the work between two items.</param>
    public static void Run(int threads, int items, Action<int, int> work, CancellationToken cancellation)
    {
        int next = -1;
        void Worker(int worker)
        {
            for (int item = Interlocked.Increment(ref next); item < items; item = Interlocked.Increment(ref next))
            {
                cancellation.ThrowIfCancellationRequested();
                work(worker, item);
            }
        }

        int workers = Math.Min(threads, items);
        if (workers <= 1)
        {
            Worker(0);
            return;
        }

        try
        {
            Parallel.For(0, workers, new ParallelOptions { MaxDegreeOfParallelism = workers, CancellationToken = cancellation }, Worker);
        }
        catch (AggregateException exception)
        {
            // The first worker's error is the one to report: a damaged file is met by all of them.
            ExceptionDispatchInfo.Throw(exception.InnerExceptions[0]);
        }
    }
}
