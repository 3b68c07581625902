using System.Net;

namespace Msisf.App.Settings;

/// <summary>Where a server listens.</summary>
/// <param name="EndPoint">Address and port; null for a Unix socket.</param>
/// <param name="SocketPath">Whole path of the Unix socket; null for an address.</param>
internal sealed record ListenAddress(IPEndPoint? EndPoint, string? SocketPath)
{
    /// <summary>Whether only this computer can reach it.</summary>
    public bool IsLocal => EndPoint is null || IPAddress.IsLoopback(EndPoint.Address);

    /// <summary>Reads ADDRESS:PORT, or the path of a Unix socket.</summary>
    /// <exception cref="BadInputException">The text is neither.</exception>
    public static ListenAddress Parse(string text)
    {
        if (text.Contains('/', StringComparison.Ordinal))
        {
            return new ListenAddress(null, Path.GetFullPath(text));
        }

        int colon = text.LastIndexOf(':');
        string host = colon < 0 ? text : text[..colon];
        string address = host == "localhost" ? IPAddress.Loopback.ToString() : host;
        return colon > 0
            && int.TryParse(text.AsSpan(colon + 1), NumberStyles.None, CultureInfo.InvariantCulture, out int port)
            && port <= IPEndPoint.MaxPort
            && (address.Contains(':', StringComparison.Ordinal) ? address is ['[', .., ']'] : address.Count(letter => letter == '.') == 3)
            && IPAddress.TryParse(address.Trim('[', ']'), out IPAddress? parsed)
                ? new ListenAddress(new IPEndPoint(parsed, port), null)
                : throw new BadInputException(
                    $"'{text}' is no address with a port, such as 127.0.0.1:8810 or [::1]:0, and no path of a Unix socket, such as "
                        + "./msis.sock.");
    }

    public override string ToString() => SocketPath ?? EndPoint!.ToString();
}
