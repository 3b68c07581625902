namespace Msisf.Server;

/// <summary>
/// Tells clients of one address apart by when they connect: a program that asks for much at once opens its connections one right after the
/// other, and later ones right after earlier ones end. A connection that comes alone is that of another program. Thread-safe.
/// </summary>
/// <param name="longestGap">Between an event and the next opening of the same program.</param>
internal sealed class ConnectionBursts(TimeSpan longestGap)
{
    private readonly Lock _gate = new();
    private readonly Dictionary<string, Burst> _latest = new(StringComparer.Ordinal);
    private long _count;

    /// <summary>Number of the burst that a new connection belongs to.</summary>
    /// <param name="address">Where it comes from.</param>
    /// <param name="now">Since any moment; never less than before.</param>
    public long Opened(string address, TimeSpan now)
    {
        lock (_gate)
        {
            if (_latest.TryGetValue(address, out Burst latest) && now - latest.LastEvent <= longestGap)
            {
                _latest[address] = latest with { LastEvent = now };
                return latest.Number;
            }

            foreach (string past in _latest.Where(burst => now - burst.Value.LastEvent > longestGap).Select(burst => burst.Key).ToArray())
            {
                _latest.Remove(past);
            }

            _latest[address] = new Burst(++_count, now);
            return _count;
        }
    }

    /// <summary>Notes the end of a connection, after which its program may open another.</summary>
    /// <param name="address">Where it came from.</param>
    /// <param name="number">The burst that it belonged to.</param>
    /// <param name="now">Since the same moment.</param>
    public void Closed(string address, long number, TimeSpan now)
    {
        lock (_gate)
        {
            _latest[address] = new Burst(number, now);
        }
    }

    private readonly record struct Burst(long Number, TimeSpan LastEvent);
}
