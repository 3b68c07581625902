using System.Collections.Concurrent;
using System.Diagnostics.CodeAnalysis;
using Msisf.Adapters.Ephemeris;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Metadata;

namespace Msisf.App.Serving;

/// <summary>The sessions of a server: those that were used last stay warm. Thread-safe.</summary>
internal sealed class RenderSessions(ProgramHost host) : IDisposable
{
    private const int MaxSessions = 32;
    private const int MaxMaps = 8;

    private readonly SharedCache<RenderSession> _sessions = new(MaxSessions);
    private readonly SharedCache<SurfaceInputs> _maps = new(MaxMaps);
    private readonly ServedSky _sky = new(host.Log);
    private readonly ServedEphemeris _ephemeris = new(host);

    public ServedEphemeris Ephemeris => _ephemeris;

    /// <summary>Number of warm sessions.</summary>
    public int Count => _sessions.Count;

    /// <summary>The session of a requested frame; dispose the lease when the frame is done.</summary>
    public SharedCache<RenderSession>.Lease Rent(RequestedFrame requested) =>
        _sessions.Rent(requested.SessionKey, () => Open(requested));

    public void Dispose()
    {
        _sessions.Dispose();
        _maps.Dispose();
        _ephemeris.Dispose();
    }

    private RenderSession Open(RequestedFrame requested)
    {
        SharedCache<SurfaceInputs>.Lease lease = _maps.Rent(requested.MapsKey, () => SurfaceInputs.Open(requested.Settings, host));
        try
        {
            return new RenderSession(requested, lease, _sky.Of(requested.Settings.Native.Sky), _ephemeris, host);
        }
        catch
        {
            lease.Dispose();
            throw;
        }
    }
}

/// <summary>
/// Keeps the values that were used last. A value that is in use is never disposed, even if there are more than the cache may hold.
/// Thread-safe.
/// </summary>
/// <typeparam name="T">Type of the values; disposed when they leave the cache.</typeparam>
/// <param name="capacity">Number of values that are kept.</param>
internal sealed class SharedCache<[DynamicallyAccessedMembers(ForLazy)] T>(int capacity) : IDisposable
    where T : IDisposable
{
    /// <summary>What <see cref="Lazy{T}"/> may use of its type, so that a compiler ahead of time keeps it.</summary>
    private const DynamicallyAccessedMemberTypes ForLazy = DynamicallyAccessedMemberTypes.PublicParameterlessConstructor;

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

/// <summary>The ephemeris engines of a server, each opened once, and the checksums of what frames are made from. Thread-safe.</summary>
internal sealed class ServedEphemeris(ProgramHost host) : IDisposable
{
    private readonly Lock _gate = new();
    private readonly Dictionary<EphemerisChoice, EphemerisSource> _sources = [];
    private readonly ConcurrentDictionary<(string Model, bool IgnoreSun), Lazy<RunInputs>> _inputs = new();

    /// <summary>The opened engine that settings ask for.</summary>
    public EphemerisSource Of(RenderSettings settings)
    {
        lock (_gate)
        {
            if (!_sources.TryGetValue(settings.Ephemeris, out EphemerisSource? source))
            {
                source = new EphemerisSource(settings, host);
                source.Engine();
                _sources.Add(settings.Ephemeris, source);
            }

            return source;
        }
    }

    /// <summary>The files of a model and the kernels, with their checksums, which are computed once.</summary>
    public IReadOnlyList<InputFile> InputsOf(ServedModel model, RenderSettings settings) => _inputs.GetOrAdd(
        (model.Name, settings.IgnoreSun),
        key => new Lazy<RunInputs>(() =>
        {
            RunInputs inputs = new(() => key.IgnoreSun ? [] : Of(settings).KernelFiles(), host, CancellationToken.None);
            inputs.Begin(model.Opened.Sets, []);
            return inputs;
        })).Value.All(camera: null);

    public void Dispose()
    {
        foreach (Lazy<RunInputs> inputs in _inputs.Values.Where(inputs => inputs.IsValueCreated))
        {
            inputs.Value.Dispose();
        }

        foreach (EphemerisSource source in _sources.Values)
        {
            source.Dispose();
        }
    }
}
