using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>A web server of one file that answers requests for parts of it well or badly.</summary>
internal sealed class RangeServer : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly byte[] _content;
    private readonly RangeFault _fault;

    public RangeServer(byte[] content, RangeFault fault)
    {
        (_content, _fault) = (content, fault);
        _listener.Start();
        new Thread(Accept) { IsBackground = true }.Start();
    }

    /// <summary>The file's address, for GDAL.</summary>
    /// <param name="options">A slash, or options of the request as GDAL writes them.</param>
    public string Path(string options = "/") => string.Create(
        CultureInfo.InvariantCulture, $"/vsicurl{options}http://127.0.0.1:{((IPEndPoint)_listener.LocalEndpoint).Port}/site.tif");

    public void Dispose() => _listener.Dispose();

    private void Accept()
    {
        try
        {
            while (true)
            {
                TcpClient client = _listener.AcceptTcpClient();
                new Thread(() => Serve(client)) { IsBackground = true }.Start();
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or InvalidOperationException)
        {
            // disposed
        }
    }

    private void Serve(TcpClient client)
    {
        using (client)
        {
            try
            {
                using NetworkStream stream = client.GetStream();
                using StreamReader reader = new(stream, Encoding.ASCII, leaveOpen: true);
                while (reader.ReadLine() is { Length: > 0 } request)
                {
                    string? range = null;
                    while (reader.ReadLine() is { Length: > 0 } header)
                    {
                        range = header.StartsWith("Range: bytes=", StringComparison.OrdinalIgnoreCase) ? header[13..] : range;
                    }

                    if (!Answer(stream, request, range))
                    {
                        return;
                    }
                }
            }
            catch (IOException)
            {
                // the client has gone
            }
        }
    }

    /// <summary>Answers a request; false ends the connection.</summary>
    private bool Answer(NetworkStream stream, string request, string? range)
    {
        if (!request.Contains(" /site.tif ", StringComparison.Ordinal))
        {
            Send(stream, "404 Not Found", 0, string.Empty);
            return true;
        }

        if (_fault == RangeFault.Hangs)
        {
            stream.ReadByte(); // until the client goes
            return false;
        }

        int length = _fault switch
        {
            RangeFault.SaysTooMuch => 2 * _content.Length,
            RangeFault.SaysTooLittle => _content.Length / 2,
            _ => _content.Length,
        };
        (int first, int end) = (0, length);
        if (range?.Split('-') is [var from, var to])
        {
            first = int.Parse(from, CultureInfo.InvariantCulture);
            end = Math.Min(int.Parse(to, CultureInfo.InvariantCulture) + 1, length);
        }

        string place = string.Create(CultureInfo.InvariantCulture, $"Content-Range: bytes {first}-{end - 1}/{length}\r\n");
        Send(stream, range is null ? "200 OK" : "206 Partial Content", end - first, range is null ? string.Empty : place);
        if (request.StartsWith("HEAD", StringComparison.Ordinal))
        {
            return true;
        }

        int sent = Math.Clamp(_content.Length - first, 0, end - first);
        sent = _fault switch
        {
            RangeFault.BreaksOffInHead => Math.Min(sent, 400),
            RangeFault.BreaksOff when first > 0 => sent / 2,
            _ => sent,
        };
        stream.Write(_content, first, sent);
        return sent == end - first;
    }

    private static void Send(NetworkStream stream, string status, int length, string more)
    {
        FormattableString head = $"HTTP/1.1 {status}\r\nContent-Length: {length}\r\nAccept-Ranges: bytes\r\n{more}\r\n";
        stream.Write(Encoding.ASCII.GetBytes(FormattableString.Invariant(head)));
    }
}

/// <summary>What a server does wrong.</summary>
public enum RangeFault
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>It takes connections and never answers.</summary>
    Hangs,

    /// <summary>It ends each connection within the file's first bytes.</summary>
    BreaksOffInHead,

    /// <summary>It ends each connection in the middle of a part behind the first.</summary>
    BreaksOff,

    /// <summary>It says that the file is twice as long.</summary>
    SaysTooMuch,

    /// <summary>It says that the file is half as long, and sends no more.</summary>
    SaysTooLittle,
}
