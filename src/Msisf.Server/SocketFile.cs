using System.Net.Sockets;
using System.Text;

namespace Msisf.Server;

/// <summary>
/// The file of the Unix socket on which a server listens. Only this server's own file is ever deleted: the socket is bound under another
/// name and gets its own when it is seen that nothing is lost by that.
/// </summary>
/// <param name="path">Whole path of the socket.</param>
internal sealed class SocketFile(string path) : IDisposable
{
    /// <summary>bytes: what systems allow, 104 at least, less the longest process id of <see cref="BoundPath"/>.</summary>
    private const int LongestPath = 92;

    /// <summary>errno of opening a socket as a file: ENXIO on Linux, EOPNOTSUPP on macOS.</summary>
    private static readonly int[] IsNoFile = [6, 102];

    private DateTime? _made;

    /// <summary>Where the server binds the socket; when it ends, .NET deletes what has this name.</summary>
    public string BoundPath { get; } = Invariant($"{path}.{Environment.ProcessId}");

    /// <summary>Refuses a path that is too long for a socket.</summary>
    /// <exception cref="ExternalPartException">It is.</exception>
    public void RequireShortPath()
    {
        int length = Encoding.UTF8.GetByteCount(path);
        if (length > LongestPath)
        {
            throw Problem(Invariant($"the path has {length} bytes, of {LongestPath} that a Unix socket may have. Use a shorter one."));
        }
    }

    /// <summary>Gives the bound socket its name. A socket on which nobody listens any more is replaced.</summary>
    /// <exception cref="ExternalPartException">Something else has the name.</exception>
    public void Publish()
    {
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(BoundPath, UnixFileMode.UserRead | UnixFileMode.UserWrite);
        }

        bool isThere = Path.Exists(path);
        if (isThere && !IsSocket())
        {
            throw Problem("there is a file or folder of this name, which is left as it is. Choose another path.");
        }

        if (isThere && IsListenedOn())
        {
            throw Problem("another server listens there. End it, or choose another path.");
        }

        DateTime made = File.GetLastWriteTimeUtc(BoundPath);
        File.Move(BoundPath, path, overwrite: isThere);
        _made = made;
    }

    /// <summary>Deletes the socket, unless its name belongs to something newer now.</summary>
    public void Dispose()
    {
        if (_made is { } made && File.GetLastWriteTimeUtc(path) == made)
        {
            File.Delete(path);
        }
    }

    private ExternalPartException Problem(string text) => new($"--listen {path}: {text}");

    private bool IsSocket()
    {
        try
        {
            using FileStream file = new(path, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete);
            return false;
        }
        catch (UnauthorizedAccessException)
        {
            return false; // a folder, or what belongs to another user
        }
        catch (IOException exception)
        {
            return IsNoFile.Contains(exception.HResult);
        }
    }

    private bool IsListenedOn()
    {
        using Socket client = new(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        try
        {
            client.Connect(new UnixDomainSocketEndPoint(path));
            return true;
        }
        catch (SocketException exception)
        {
            return exception.SocketErrorCode != SocketError.ConnectionRefused; // in doubt it stays
        }
    }
}
