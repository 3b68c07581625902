using System.Net.Sockets;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The Unix socket of <c>--listen PATH</c>: what lies there is lost only if it is a socket without a server.</summary>
public sealed class SocketFileTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("msis").FullName; // short: so is the path of a socket

    private string SocketPath => Path.Combine(_folder, "sock");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [RequiresFact(Part.Ldem4)]
    public async Task Socket_Answers_AndIsRemovedAtTheEnd()
    {
        using RunningServer running = await StartAsync(SocketPath);

        Assert.Equal("ok\n", await AskAsync());
        Assert.True(
            OperatingSystem.IsWindows() || File.GetUnixFileMode(SocketPath) == (UnixFileMode.UserRead | UnixFileMode.UserWrite),
            "others may use the socket");
        await running.DisposeAsync();
        Assert.Empty(Directory.GetFileSystemEntries(_folder));
    }

    /// <summary>As docs/server.md has it: relative to the current folder.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task RelativePath_IsListenedOn()
    {
        using RunningServer running = await StartAsync(Path.GetRelativePath(Environment.CurrentDirectory, SocketPath));

        Assert.Equal(SocketPath, running.Address);
        Assert.Equal("ok\n", await AskAsync());
        await running.DisposeAsync();
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData(false)]
    [InlineData(true)]
    public async Task FileOrFolderOfTheName_StaysAsItIs(bool isFolder)
    {
        if (isFolder)
        {
            Directory.CreateDirectory(SocketPath);
        }
        else
        {
            File.WriteAllText(SocketPath, "results of a year");
        }

        ExternalPartException exception = await Assert.ThrowsAsync<ExternalPartException>(() => StartAsync(SocketPath));

        Assert.Equal(
            $"--listen {SocketPath}: there is a file or folder of this name, which is left as it is. Choose another path.",
            exception.Message);
        Assert.Equal([SocketPath], Directory.GetFileSystemEntries(_folder));
        Assert.True(isFolder || File.ReadAllText(SocketPath) == "results of a year");
    }

    [RequiresFact(Part.Ldem4)]
    public async Task SocketOfALivingServer_StaysItsOwn()
    {
        using RunningServer living = await StartAsync(SocketPath);

        ExternalPartException exception = await Assert.ThrowsAsync<ExternalPartException>(() => StartAsync(SocketPath));

        Assert.Equal($"--listen {SocketPath}: another server listens there. End it, or choose another path.", exception.Message);
        Assert.Equal("ok\n", await AskAsync());
        await living.DisposeAsync();
        Assert.Empty(Directory.GetFileSystemEntries(_folder));
    }

    /// <summary>What a server leaves that was killed.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task SocketOfADeadServer_IsReplaced()
    {
        using (Socket dead = new(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified))
        {
            dead.Bind(new UnixDomainSocketEndPoint(SocketPath + ".bound"));
            File.Move(SocketPath + ".bound", SocketPath); // so that closing it does not delete it
        }

        using RunningServer running = await StartAsync(SocketPath);

        Assert.Equal("ok\n", await AskAsync());
        await running.DisposeAsync();
    }

    /// <summary>The user deletes the socket and starts another server, before the first one ends.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task SocketOfALaterServer_IsNotRemoved_ByTheFirst()
    {
        using RunningServer first = await StartAsync(SocketPath);
        File.Delete(SocketPath);
        File.WriteAllText(SocketPath, "something else");

        await first.DisposeAsync();

        Assert.Equal("something else", File.ReadAllText(SocketPath));
    }

    [RequiresFact(Part.Ldem4)]
    public async Task LongPath_OrMissingFolder_IsNamed()
    {
        ExternalPartException tooLong = await Assert.ThrowsAsync<ExternalPartException>(
            () => StartAsync(Path.Combine(_folder, new string('s', 100))));
        ExternalPartException missing = await Assert.ThrowsAsync<ExternalPartException>(
            () => StartAsync(Path.Combine(_folder, "no", "sock")));

        Assert.Contains("of 92 that a Unix socket may have", tooLong.Message, StringComparison.Ordinal);
        Assert.Contains("can't be listened on", missing.Message, StringComparison.Ordinal);
    }

    /// <summary>An address that this computer does not have (RFC 5737).</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task ForeignAddress_IsNamed()
    {
        using TemporaryFolder folder = new();

        ExternalPartException exception = await Assert.ThrowsAsync<ExternalPartException>(() => RunningServer.StartAsync(
            (ServeOptions.Listen, "192.0.2.1:8810"), (ServeOptions.TokenFile, folder.Write("token", "0123456789abcdef\n"))));

        Assert.Contains("--listen 192.0.2.1:8810: can't be listened on", exception.Message, StringComparison.Ordinal);
    }

    private static Task<RunningServer> StartAsync(string path) => RunningServer.StartAsync((ServeOptions.Listen, path));

    private async Task<string> AskAsync()
    {
        using SocketsHttpHandler handler = new()
        {
            ConnectCallback = async (_, cancellation) =>
            {
                Socket socket = new(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
                await socket.ConnectAsync(new UnixDomainSocketEndPoint(SocketPath), cancellation);
                return new NetworkStream(socket, ownsSocket: true);
            },
        };
        using HttpClient client = new(handler);
        return await client.GetStringAsync(new Uri("http://localhost/healthz"));
    }
}
