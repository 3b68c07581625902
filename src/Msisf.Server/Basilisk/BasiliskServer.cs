using System.Buffers.Binary;
using System.Text;
using Msisf.App.Host;
using Msisf.App.Settings;
using NetMQ;
using NetMQ.Sockets;

namespace Msisf.Server.Basilisk;

/// <summary>
/// Answers what Basilisk's vizInterface asks Vizard in lock-step (docs/clients.md). Each simulation is a peer of its own: several may
/// run at once.
/// </summary>
internal sealed class BasiliskServer : IAsyncDisposable
{
    /// <summary>bytes: a message of 100,000 bodies; a longer one is not from vizInterface.</summary>
    private const long LargestMessage = 64L << 20;

    /// <summary>Simulations that are remembered: one that ends says nothing.</summary>
    private const int MaxSimulations = 64;

    private const string ImageRequest = "REQUEST_IMAGE";

    private readonly RouterSocket _socket = new();
    private readonly NetMQQueue<NetMQMessage> _answers = new();
    private readonly NetMQPoller _poller;
    private readonly FrameService _frames;
    private readonly BasiliskSettings _settings;
    private readonly ILog _log;
    private readonly CancellationTokenSource _end = new();
    private readonly LinkedList<(string Peer, BasiliskSimulation Simulation)> _simulations = [];
    private int _count;

    private BasiliskServer(FrameService frames, BasiliskSettings settings, ILog log)
    {
        (_frames, _settings, _log) = (frames, settings, log);
        _socket.Options.MaxMsgSize = LargestMessage;
        _socket.ReceiveReady += (_, _) => Receive();
        _answers.ReceiveReady += (_, _) => Send();
        _poller = [_socket, _answers];
    }

    /// <summary>Where simulations find the server.</summary>
    public string Address => _socket.Options.LastEndpoint!;

    /// <param name="settings">Its settings, with those for Basilisk.</param>
    /// <exception cref="MsisfException">There is no elevation model or camera, or the address can't be listened on.</exception>
    public static BasiliskServer Start(ServeSettings settings, ProgramHost host)
    {
        ServerThreads.Reserve();
        FrameService frames = new(settings, host);
        BasiliskServer server = new(frames, BasiliskSettings.Read(settings, frames), host.Log);
        string address = settings.Basilisk!;
        try
        {
            server._socket.Bind(address.Replace("//localhost:", "//127.0.0.1:", StringComparison.Ordinal));
        }
        catch (NetMQException exception)
        {
            string why = exception.ErrorCode switch
            {
                ErrorCode.AddressAlreadyInUse => "another program listens there. End it, or choose another port.",
                ErrorCode.AddressNotAvailable => "this computer has no such address. Choose one that it has.",
                ErrorCode.AccessDenied => "the system does not allow it. Choose a port from 1024 on.",
                _ => $"{exception.ErrorCode}. Choose another address or port.",
            };
            throw new ExternalPartException($"{ServeOptions.Basilisk.Name} {address}: can't be listened on: {why}", exception);
        }

        server._poller.RunAsync("Basilisk");
        host.Log.Note($"Listening for Basilisk on {server.Address} until {(settings.EndsWithInput ? "its client" : "a signal")} ends it.");
        return server;
    }

    /// <summary>Serves until the input ends, or the program gets a signal. Images in work are dropped.</summary>
    /// <param name="input">Its end ends the server, if that is wanted.</param>
    public static async Task RunAsync(TextReader input)
    {
        using EndOfServer end = new(() => { });
        await end.WaitAsync(input).ConfigureAwait(false);
    }

    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync().ConfigureAwait(false);
        _poller.Dispose();
        _socket.Dispose();
        _answers.Dispose();
        NetMQConfig.Cleanup(block: false);
        _settings.Dispose();
        await _frames.DisposeAsync().ConfigureAwait(false);
        _end.Dispose();
    }

    private void Receive()
    {
        NetMQMessage? request = null;
        if (!_socket.TryReceiveMultipartMessage(ref request) || request is null || request.FrameCount < 2)
        {
            return; // no REQ socket is there, so nobody waits
        }

        byte[] peer = request[0].ToByteArray();
        BasiliskSimulation simulation = SimulationOf(Convert.ToHexString(peer));
        int head = request[1].IsEmpty ? 2 : 1; // a REQ socket puts an empty frame before its own
        byte[][] frames = [.. request.Skip(head).Select(frame => frame.ToByteArray())];
        _ = AnswerAsync(peer, simulation, frames);
    }

    private async Task AnswerAsync(byte[] peer, BasiliskSimulation simulation, byte[][] frames)
    {
        try
        {
            byte[][] answer = await AnswerToAsync(simulation, frames).ConfigureAwait(false);
            NetMQMessage message = new([peer, [], .. answer]);
            _answers.Enqueue(message);
        }
        catch (Exception exception) when (exception is OperationCanceledException or ObjectDisposedException)
        {
            // The server ends.
        }
    }

    private async Task<byte[][]> AnswerToAsync(BasiliskSimulation simulation, byte[][] frames)
    {
        string command = frames.Length > 0 ? Encoding.ASCII.GetString(frames[0]) : string.Empty;
        switch (command)
        {
            case "PING":
                return [Encoding.ASCII.GetBytes("PONG")];
            case "SIM_UPDATE":
                simulation.Update(frames.Length > 1 ? frames[^1] : []);
                return [Encoding.ASCII.GetBytes("OK")]; // anything else ends the user's script
            case "REQUEST_INPUT":
                return [Encoding.ASCII.GetBytes("VIZARD_INPUT"), []];
        }

        if (!command.StartsWith(ImageRequest, StringComparison.Ordinal))
        {
            return [Encoding.ASCII.GetBytes("UNKNOWN")];
        }

        string camera = command[ImageRequest.Length..].TrimStart('_');
        byte[] image = await simulation.DrawAsync(camera, _end.Token).ConfigureAwait(false) ?? [];
        byte[] length = new byte[sizeof(int)];
        BinaryPrimitives.WriteInt32BigEndian(length, image.Length);
        return [length, image];
    }

    private void Send()
    {
        while (_answers.TryDequeue(out NetMQMessage? message, TimeSpan.Zero))
        {
            _socket.TrySendMultipartMessage(message);
        }
    }

    private BasiliskSimulation SimulationOf(string peer)
    {
        LinkedListNode<(string Peer, BasiliskSimulation Simulation)>? known = _simulations.First;
        while (known is not null && known.Value.Peer != peer)
        {
            known = known.Next;
        }

        if (known is not null)
        {
            _simulations.Remove(known);
            _simulations.AddFirst(known);
            return known.Value.Simulation;
        }

        int number = ++_count;
        HashSet<string> said = [];
        BasiliskSimulation simulation = new(_frames, _settings, _log, text =>
        {
            lock (said)
            {
                if (said.Add(text))
                {
                    _log.Note($"Simulation {number}: {text}");
                }
            }
        });
        _simulations.AddFirst((peer, simulation));
        if (_simulations.Count > MaxSimulations)
        {
            _simulations.RemoveLast();
        }

        return simulation;
    }
}
