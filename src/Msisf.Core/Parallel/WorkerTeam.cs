using System.Runtime.ExceptionServices;

namespace Msisf.Core.Parallel;

/// <summary>
/// Distributes items of work among threads. Which thread does which item is not defined, so items must not depend on each other.
/// </summary>
internal static class WorkerTeam
{
    /// <summary>Runs the work once for every item.</summary>
    /// <param name="threads">Maximum number of workers, at least 1.</param>
    /// <param name="work">Is called with the worker's index (from 0) and the item's index; a worker does one item at a time.</param>
    /// <param name="cancellation">Stops the work between two items.</param>
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
            ParallelOptions options = new() { MaxDegreeOfParallelism = workers, CancellationToken = cancellation };
            System.Threading.Tasks.Parallel.For(0, workers, options, Worker);
        }
        catch (AggregateException exception)
        {
            // Only the first worker's error is reported: all workers fail in the same way on a damaged file.
            ExceptionDispatchInfo.Throw(exception.InnerExceptions[0]);
        }
    }
}
