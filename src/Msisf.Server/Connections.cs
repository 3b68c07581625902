using System.Collections.Concurrent;
using System.Net;
using Microsoft.AspNetCore.Connections;

namespace Msisf.Server;

/// <summary>
/// The connections of clients. One that sends no request soon after it was opened is closed; when there are too many, the one that has been
/// idle for the longest time makes room. So nobody keeps others out by being silent. Thread-safe.
/// </summary>
/// <param name="most">How many there may be.</param>
/// <param name="longestSilence">From connecting to the end of the first request's head.</param>
internal sealed class Connections(int most, TimeSpan longestSilence)
{
    /// <summary>Between two connections that a program opens at once, on a machine under load.</summary>
    private static readonly TimeSpan LongestGap = TimeSpan.FromSeconds(0.5);

    private readonly ConcurrentDictionary<Connection, bool> _open = [];
    private readonly ConnectionBursts _bursts = new(LongestGap);

    /// <param name="context">The connection; its requests find their <see cref="Connection"/> among the features.</param>
    /// <param name="next">Serves it.</param>
    public async Task HandleAsync(ConnectionContext context, ConnectionDelegate next)
    {
        string address = ((context.RemoteEndPoint as IPEndPoint)?.Address)?.ToString() ?? string.Empty;
        Connection connection = new(context, _bursts.Opened(address, Now));
        _open[connection] = true;
        if (_open.Count > most && !MakeRoom(connection))
        {
            _open.TryRemove(connection, out _);
            context.Abort();
            return;
        }

        context.Features.Set(connection);
        using Timer silence = new(_ => connection.CloseIfUnused(), null, longestSilence, Timeout.InfiniteTimeSpan);
        try
        {
            await next(context).ConfigureAwait(false);
        }
        finally
        {
            _open.TryRemove(connection, out _);
            _bursts.Closed(address, connection.Burst, Now);
        }
    }

    private static TimeSpan Now => TimeSpan.FromMilliseconds(Environment.TickCount64);

    private bool MakeRoom(Connection newest)
    {
        Connection? idle = _open.Keys.Where(open => open.IsIdle && open != newest).MinBy(open => open.IdleSince);
        if (idle is null)
        {
            return false;
        }

        _open.TryRemove(idle, out _);
        idle.Close();
        return true;
    }
}

/// <summary>A connection of a client. Thread-safe.</summary>
/// <param name="context">The connection.</param>
/// <param name="burst">The number of its burst, of all addresses.</param>
internal sealed class Connection(ConnectionContext context, long burst)
{
    private int _requests;
    private volatile bool _isUsed;
    private long _idleSince = Environment.TickCount64;

    /// <summary>Number of those that one program opened together (<see cref="ConnectionBursts"/>).</summary>
    public long Burst => burst;

    /// <summary>Whether no request of the connection is being answered.</summary>
    public bool IsIdle => Volatile.Read(ref _requests) == 0;

    /// <summary>ms, of the system's clock: when it was opened, or its last answer ended.</summary>
    public long IdleSince => Volatile.Read(ref _idleSince);

    /// <summary>Notes that a request has come.</summary>
    public void RequestBegins()
    {
        _isUsed = true;
        Interlocked.Increment(ref _requests);
    }

    /// <summary>Notes that a request is answered.</summary>
    public void RequestEnds()
    {
        Volatile.Write(ref _idleSince, Environment.TickCount64);
        Interlocked.Decrement(ref _requests);
    }

    /// <summary>Closes a connection of which no request has come.</summary>
    public void CloseIfUnused()
    {
        if (!_isUsed)
        {
            Close();
        }
    }

    public void Close() => context.Abort(new ConnectionAbortedException("The client sends no request."));
}
