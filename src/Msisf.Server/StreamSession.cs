using System.Buffers.Binary;
using System.Net.WebSockets;
using System.Text.Json;
using System.Text.Json.Serialization;
using System.Threading.Channels;
using Msisf.App.Preparation;
using Msisf.App.Serving;
using Msisf.App.Settings;

namespace Msisf.Server;

/// <summary>One WebSocket: the first message says the camera and its options, each further one where it is.</summary>
internal sealed class StreamSession : IDisposable
{
    private const int HeadLength = 16;

    /// <summary>Messages that are read ahead in lock-step.</summary>
    private const int Ahead = 16;

    /// <summary>Who opens a stream says at once what for.</summary>
    private static readonly TimeSpan LongestOpening = TimeSpan.FromSeconds(10);

    /// <summary>How long a client may take to hear that the server ends.</summary>
    private static readonly TimeSpan LongestClosing = TimeSpan.FromMilliseconds(200);

    private static ReadOnlySpan<byte> Magic => "MSIF"u8;

    private readonly FrameService _frames;
    private readonly StreamSocket _socket;
    private readonly CancellationTokenSource _gone;
    private readonly CancellationToken _stopping;
    private StreamOpening? _opening;
    private RequestedFrame[] _cameras = [];
    private uint _number;
    private uint _numberOfFirst;

    private StreamSession(FrameService frames, WebSocket socket, CancellationToken aborted, CancellationToken stopping)
    {
        (_frames, _socket, _stopping) = (frames, new StreamSocket(socket, StreamMessage.StateWithMotionLength), stopping);
        _gone = CancellationTokenSource.CreateLinkedTokenSource(aborted);
    }

    /// <summary>Answers GET /v1/stream, a WebSocket on which states go in and images come out, until it is closed.</summary>
    /// <param name="stopping">The server ends.</param>
    public static async Task AnswerAsync(HttpContext context, FrameService frames, CancellationToken stopping)
    {
        if (!context.WebSockets.IsWebSocketRequest)
        {
            throw new RefusedException(StatusCodes.Status426UpgradeRequired, "/v1/stream is a WebSocket.");
        }

        using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync().ConfigureAwait(false);
        frames.Metrics.StreamsChanged(1);
        try
        {
            using StreamSession session = new(frames, socket, context.RequestAborted, stopping);
            await session.RunAsync().ConfigureAwait(false);
        }
        finally
        {
            frames.Metrics.StreamsChanged(-1);
        }
    }

    private async Task RunAsync()
    {
        try
        {
            using CancellationTokenSource late = CancellationTokenSource.CreateLinkedTokenSource(_gone.Token, _stopping);
            late.CancelAfter(LongestOpening);
            if (await _socket.ReceiveAsync(late.Token).ConfigureAwait(false) is not { } first
                || !await OpenAsync(first).ConfigureAwait(false))
            {
                await _socket.CloseAsync(WebSocketCloseStatus.PolicyViolation, "the first message says the frame", _gone.Token)
                    .ConfigureAwait(false);
                return;
            }

            int ahead = _opening!.IsNewestOnly ? 1 : Ahead;
            Channel<StreamMessage> messages = Channel.CreateBounded<StreamMessage>(new BoundedChannelOptions(ahead)
            {
                FullMode = _opening.IsNewestOnly ? BoundedChannelFullMode.DropOldest : BoundedChannelFullMode.Wait,
                SingleReader = true,
                AllowSynchronousContinuations = true, // a state is drawn without a change of threads
            });
            Task reading = ReadAsync(messages.Writer);
            using CancellationTokenRegistration end = _stopping.Register(() => messages.Writer.TryComplete());
            await foreach (StreamMessage message in messages.Reader.ReadAllAsync(_gone.Token).ConfigureAwait(false))
            {
                await AnswerAsync(message).ConfigureAwait(false);
                if (_stopping.IsCancellationRequested)
                {
                    break;
                }
            }

            await _socket.CloseAsync(
                _stopping.IsCancellationRequested ? WebSocketCloseStatus.EndpointUnavailable : WebSocketCloseStatus.NormalClosure,
                "end",
                _gone.Token).ConfigureAwait(false);
            if (await Task.WhenAny(reading, Task.Delay(LongestClosing)).ConfigureAwait(false) != reading)
            {
                _socket.Abort();
            }

            await reading.ConfigureAwait(false);
        }
        catch (Exception exception) when (exception is WebSocketException or OperationCanceledException)
        {
            // The client is gone, in the middle of a message or between two; its work ends.
            _socket.Abort();
        }
    }

    public void Dispose()
    {
        _gone.Cancel();
        _gone.Dispose();
    }

    /// <summary>Reads the first message.</summary>
    /// <returns>Whether the session can begin; the client has been told.</returns>
    private async Task<bool> OpenAsync(StreamMessage message)
    {
        try
        {
            _opening = StreamOpening.Read(JsonText.Parse(message.Bytes));
            _cameras = [.. _opening.Cameras.Select(camera => camera.InStream(_frames, _opening.Frame))];
            RenderSettings first = _cameras[0].Settings;
            await _socket.SendJsonAsync(
                new StreamReady(
                    Ready: true, first.Width, first.Height,
                    _cameras.Select(camera => new StreamImageSize(camera.Settings.Width, camera.Settings.Height))),
                _gone.Token).ConfigureAwait(false);
            return true;
        }
        catch (Exception exception) when (Problem.Of(exception) is not null)
        {
            await SendErrorAsync(exception, number: null).ConfigureAwait(false);
            return false;
        }
    }

    /// <summary>Draws the images of a message and sends them, or what is wrong with the first of them that can't be drawn.</summary>
    private async Task AnswerAsync(StreamMessage message)
    {
        _number = message.Order + _numberOfFirst; // counts states that were left out too: the client knows which one this is
        try
        {
            (RequestedFrame Requested, TrajectorySettings Place)[] images = message.Type == WebSocketMessageType.Binary
                ? PlacesOf(message)
                : ReadChanges(message);
            Task sending = Task.CompletedTask;
            SharedReadings shared = new();
            foreach ((RequestedFrame requested, TrajectorySettings place) in images)
            {
                sending = await DrawAsync(requested, place, shared, sending).ConfigureAwait(false);
            }

            await sending.ConfigureAwait(false);
        }
        catch (Exception exception) when (Problem.Of(exception) is not null)
        {
            await SendErrorAsync(exception, _number).ConfigureAwait(false);
        }
    }

    /// <summary>Draws an image while that of the camera before is sent, and begins to send it.</summary>
    /// <param name="shared">What the images before have read.</param>
    private async Task<Task> DrawAsync(RequestedFrame requested, TrajectorySettings place, SharedReadings shared, Task before)
    {
        Answer answer = _frames.Answers.InMemory(HeadLength);
        try
        {
            await _frames.DrawAsync(requested, place, _opening!.Form, answer, _gone.Token, shared).ConfigureAwait(false);
        }
        catch
        {
            answer.Dispose();
            throw;
        }
        finally
        {
            await before.ConfigureAwait(false);
        }

        return SendAsync(answer, requested.Settings);
    }

    /// <summary>Sends an image and gives its memory back.</summary>
    private async Task SendAsync(Answer answer, RenderSettings settings)
    {
        using (answer)
        {
            if (_opening!.IsTimed) // says before an image how many ms it waited, and took to draw and to write
            {
                Dictionary<string, double> times = answer.Times.ToDictionary(time => time.Name, time => time.Milliseconds);
                await _socket.SendJsonAsync(
                    times.Prepend(new("number", _number)).ToDictionary(), _gone.Token).ConfigureAwait(false);
            }

            AnswerPart image = answer.Joined();
            WriteHead(image.Content.GetBuffer(), settings);
            await _socket.SendAsync(image.Bytes, _gone.Token).ConfigureAwait(false);
        }
    }

    /// <summary>A state for each camera.</summary>
    private (RequestedFrame Requested, TrajectorySettings Place)[] PlacesOf(StreamMessage message)
    {
        FixedStateSettings place = message.ToPlace();
        return [.. _cameras.Select(camera => (camera, WithNoise(place, camera)))];
    }

    /// <summary>The options of the first message with those of a later one, which may give the frame's number too.</summary>
    private (RequestedFrame Requested, TrajectorySettings Place)[] ReadChanges(StreamMessage message)
    {
        Dictionary<string, JsonElement> changes = new(JsonText.Members(JsonText.Parse(message.Bytes)), StringComparer.Ordinal);
        if (changes.Remove("number", out JsonElement number))
        {
            _number = number.ValueKind == JsonValueKind.Number && number.TryGetUInt32(out uint given)
                ? given
                : throw new UsageException("'number' is the frame's number, a whole number from 0 to 4294967295.");
            _numberOfFirst = _number - message.Order;
        }

        bool hasOwnNoise = changes.ContainsKey(NativeOptions.NoiseSeed.Key);
        IReadOnlyList<StreamCamera> cameras = _opening!.Cameras;
        return [.. StreamCamera.WithOnePlace(cameras, [.. cameras.Select(camera => camera.InStream(_frames, _opening.Frame, changes))])
            .Select(requested => (requested, hasOwnNoise ? requested.Place! : WithNoise(requested.Place!, requested)))];
    }

    /// <summary>The number of a state in the stream is its step in the series of noises that the first message chooses.</summary>
    private TrajectorySettings WithNoise(TrajectorySettings place, RequestedFrame requested) => requested.Noise is { } first
        ? place with { Noise = first with { Step = first.Step + _number - 1 } }
        : place;

    /// <summary>Reads messages ahead, so that it is noticed when the client goes away.</summary>
    private async Task ReadAsync(ChannelWriter<StreamMessage> messages)
    {
        try
        {
            while (await _socket.ReceiveAsync(_gone.Token).ConfigureAwait(false) is { } message)
            {
                await messages.WriteAsync(message, _gone.Token).ConfigureAwait(false);
            }

            messages.TryComplete();
        }
        catch (ChannelClosedException)
        {
            // The server ends; what the client sends is no longer drawn.
        }
        catch (Exception exception) when (exception is WebSocketException or OperationCanceledException)
        {
            await _gone.CancelAsync().ConfigureAwait(false);
            messages.TryComplete(exception);
        }
    }

    private void WriteHead(Span<byte> message, RenderSettings settings)
    {
        Magic.CopyTo(message);
        BinaryPrimitives.WriteUInt32LittleEndian(message[4..], _number);
        BinaryPrimitives.WriteUInt32LittleEndian(message[8..], (uint)settings.Width);
        BinaryPrimitives.WriteUInt32LittleEndian(message[12..], (uint)settings.Height);
    }

    private Task SendErrorAsync(Exception exception, uint? number)
    {
        string error = Problem.Shortened(Problem.Of(exception)!.Detail);
        return _socket.SendJsonAsync(new StreamError(number, error), _gone.Token);
    }
}

/// <summary>Answers the first message of a stream.</summary>
/// <param name="Width">Pixels, as the height, of the first camera's images.</param>
internal sealed record StreamReady(bool Ready, int Width, int Height, IEnumerable<StreamImageSize> Cameras);

/// <summary>The size of a camera's images, pixels.</summary>
internal sealed record StreamImageSize(int Width, int Height);

/// <summary>What is wrong with a message of a stream.</summary>
/// <param name="Number">The frame's; left out for the first message.</param>
internal sealed record StreamError([property: JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)] uint? Number, string Error);
