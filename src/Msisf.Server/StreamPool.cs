using System.Collections.Concurrent;

namespace Msisf.Server;

/// <summary>Memory for answers, used again: the garbage collector is slow to free what is as large as an image. Thread-safe.</summary>
internal sealed class StreamPool
{
    /// <summary>bytes: larger streams are not kept.</summary>
    private const int LargestKept = 8 << 20;

    /// <summary>Number of streams that are kept.</summary>
    private const int MostKept = 16;

    private readonly ConcurrentBag<MemoryStream> _idle = [];

    /// <summary>An empty stream.</summary>
    public MemoryStream Take()
    {
        MemoryStream stream = _idle.TryTake(out MemoryStream? idle) ? idle : new MemoryStream();
        stream.SetLength(0);
        return stream;
    }

    /// <summary>Takes a stream back.</summary>
    public void GiveBack(MemoryStream stream)
    {
        if (stream.Capacity <= LargestKept && _idle.Count < MostKept)
        {
            _idle.Add(stream);
        }
    }
}
