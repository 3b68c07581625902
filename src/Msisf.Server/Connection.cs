using Microsoft.AspNetCore.Connections;

namespace Msisf.Server;

/// <summary>A connection of a client. Thread-safe.</summary>
/// <param name="context">The connection.</param>
internal sealed class Connection(ConnectionContext context)
{
    private int _requests;
    private volatile bool _isUsed;
    private long _idleSince = Environment.TickCount64;

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

    /// <summary>Closes the connection.</summary>
    public void Close() => context.Abort(new ConnectionAbortedException("The client sends no request."));
}
