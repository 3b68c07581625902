using Msisf.App.Host;
using Msisf.App.Preparation;

namespace Msisf.App.Serving;

/// <summary>The sessions of a server: those that were used last stay warm. Thread-safe.</summary>
internal sealed class RenderSessions : IDisposable
{
    private const int MaxSessions = 32;
    private const int MaxMaps = 8;

    private readonly SharedCache<RenderSession> _sessions = new(MaxSessions);
    private readonly SharedCache<SurfaceInputs> _maps = new(MaxMaps);
    private readonly ServedEphemeris _ephemeris;
    private readonly ProgramHost _host;

    public RenderSessions(ProgramHost host) => (_host, _ephemeris) = (host, new ServedEphemeris(host));

    /// <summary>The ephemeris engines.</summary>
    public ServedEphemeris Ephemeris => _ephemeris;

    /// <summary>Number of warm sessions.</summary>
    public int Count => _sessions.Count;

    /// <summary>The session of a requested frame; dispose the lease when the frame is done.</summary>
    public SharedCache<RenderSession>.Lease Rent(RequestedFrame requested) =>
        _sessions.Rent(requested.SessionKey, () => Open(requested));

    /// <summary>Closes all sessions.</summary>
    public void Dispose()
    {
        _sessions.Dispose();
        _maps.Dispose();
        _ephemeris.Dispose();
    }

    private RenderSession Open(RequestedFrame requested)
    {
        SharedCache<SurfaceInputs>.Lease lease = _maps.Rent(requested.MapsKey, () => SurfaceInputs.Open(requested.Settings, _host));
        try
        {
            return new RenderSession(requested, lease, _ephemeris, _host);
        }
        catch
        {
            lease.Dispose();
            throw;
        }
    }
}
