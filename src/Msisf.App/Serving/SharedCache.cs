namespace Msisf.App.Serving;

/// <summary>
/// Keeps the values that were used last. A value that is in use is never disposed, even if there are more than the cache may hold.
/// Thread-safe.
/// </summary>
/// <typeparam name="T">Type of the values; disposed when they leave the cache.</typeparam>
/// <param name="capacity">Number of values that are kept.</param>
internal sealed class SharedCache<T>(int capacity) : IDisposable
    where T : IDisposable
{
    private readonly Lock _gate = new();
    private readonly Dictionary<string, Entry> _entries = new(StringComparer.Ordinal);
    private long _clock;

    /// <summary>Number of values that are there.</summary>
    public int Count
    {
        get
        {
            lock (_gate)
            {
                return _entries.Count;
            }
        }
    }

    /// <summary>The value of a key, made if it is not there; dispose the lease when it is no longer used.</summary>
    public Lease Rent(string key, Func<T> make)
    {
        Entry? entry;
        lock (_gate)
        {
            if (!_entries.TryGetValue(key, out entry))
            {
                _entries[key] = entry = new Entry(new Lazy<T>(make));
            }

            entry.Users++;
            entry.LastUse = ++_clock;
        }

        try
        {
            return new Lease(this, entry, entry.Value.Value);
        }
        catch
        {
            lock (_gate)
            {
                entry.Users--;
                if (_entries.TryGetValue(key, out Entry? kept) && ReferenceEquals(kept, entry))
                {
                    _entries.Remove(key); // the next request tries again
                }
            }

            throw;
        }
    }

    /// <summary>Disposes all values.</summary>
    public void Dispose()
    {
        foreach (Entry entry in _entries.Values.Where(entry => entry.Value.IsValueCreated))
        {
            entry.Value.Value.Dispose();
        }

        _entries.Clear();
    }

    private void GiveBack(Entry entry)
    {
        List<T> removed = [];
        lock (_gate)
        {
            entry.Users--;
            while (_entries.Count > capacity)
            {
                KeyValuePair<string, Entry>[] idle = [.. _entries.Where(pair => pair.Value.Users == 0)];
                if (idle.Length == 0)
                {
                    break;
                }

                KeyValuePair<string, Entry> oldest = idle.MinBy(pair => pair.Value.LastUse);
                _entries.Remove(oldest.Key);
                removed.Add(oldest.Value.Value.Value);
            }
        }

        removed.ForEach(value => value.Dispose());
    }

    /// <summary>A value in use.</summary>
    public sealed class Lease : IDisposable
    {
        private readonly SharedCache<T> _cache;
        private Entry? _entry;

        internal Lease(SharedCache<T> cache, Entry entry, T value) => (_cache, _entry, Value) = (cache, entry, value);

        public T Value { get; }

        /// <summary>Says that the value is no longer used.</summary>
        public void Dispose()
        {
            if (Interlocked.Exchange(ref _entry, null) is { } entry)
            {
                _cache.GiveBack(entry);
            }
        }
    }

    internal sealed class Entry(Lazy<T> value)
    {
        public Lazy<T> Value { get; } = value;

        public int Users { get; set; }

        public long LastUse { get; set; }
    }
}
