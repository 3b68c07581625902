using System.Buffers.Binary;
using System.Net.WebSockets;
using System.Text.Json;
using System.Threading.Channels;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.Core.Scene;

namespace Msisf.Server;

/// <summary>One WebSocket: the first message says the camera and its options, each further one where it is.</summary>
internal sealed class StreamSession : IDisposable
{
    /// <summary>bytes: eight doubles.</summary>
    private const int StateLength = 64;

    /// <summary>bytes: with the six of a motion.</summary>
    private const int StateWithMotionLength = 112;

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
    private JsonDocument? _opening;
    private AnswerForm _form = AnswerForm.Of(AnswerForm.Raw);
    private RequestedFrame? _frame;
    private JsonElement _base;
    private uint _number;
    private uint _numberOfFirst;
    private bool _isNewestOnly;
    private bool _isTimed;

    public StreamSession(FrameService frames, WebSocket socket, CancellationToken aborted, CancellationToken stopping)
    {
        (_frames, _socket, _stopping) = (frames, new StreamSocket(socket, StateWithMotionLength), stopping);
        _gone = CancellationTokenSource.CreateLinkedTokenSource(aborted);
    }

    /// <summary>Serves the socket until it is closed.</summary>
    public async Task RunAsync()
    {
        try
        {
            if (await ReceiveFirstAsync().ConfigureAwait(false) is not { } first
                || !await OpenAsync(first).ConfigureAwait(false))
            {
                await _socket.CloseAsync(WebSocketCloseStatus.PolicyViolation, "the first message says the frame", _gone.Token)
                    .ConfigureAwait(false);
                return;
            }

            Channel<StreamMessage> messages = Channel.CreateBounded<StreamMessage>(new BoundedChannelOptions(_isNewestOnly ? 1 : Ahead)
            {
                FullMode = _isNewestOnly ? BoundedChannelFullMode.DropOldest : BoundedChannelFullMode.Wait,
                SingleReader = true,
                SingleWriter = true,
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

    /// <summary>Ends what still goes on.</summary>
    public void Dispose()
    {
        _gone.Cancel();
        _gone.Dispose();
        _opening?.Dispose();
    }

    private async Task<StreamMessage?> ReceiveFirstAsync()
    {
        using CancellationTokenSource late = CancellationTokenSource.CreateLinkedTokenSource(_gone.Token, _stopping);
        late.CancelAfter(LongestOpening);
        return await _socket.ReceiveAsync(late.Token).ConfigureAwait(false);
    }

    /// <summary>Reads the first message.</summary>
    /// <returns>Whether the session can begin; the client has been told.</returns>
    private async Task<bool> OpenAsync(StreamMessage first)
    {
        try
        {
            _opening = JsonText.Parse(first.Bytes);
            IReadOnlyDictionary<string, JsonElement> members = JsonText.Members(_opening.RootElement);
            if (members.Keys.FirstOrDefault(key => key is not ("frame" or "mode" or "format" or "timing")) is { } unknown)
            {
                throw new UsageException($"'{unknown}' is not known here; the first message has 'frame', 'mode', 'format' and 'timing'.");
            }

            _isNewestOnly = WordOf(members, "mode", "lock-step", "newest-only") == "newest-only";
            _form = AnswerForm.Of(WordOf(members, "format", "u8", "png") == "png" ? AnswerForm.Png : AnswerForm.Raw);
            _isTimed = FlagOf(members, "timing");
            _base = FrameOf(members);
            _frame = _frames.Read(_base, needsPlace: false);
            await _socket.SendAsync(
                json =>
                {
                    json.WriteBoolean("ready", true);
                    json.WriteNumber("width", _frame.Settings.Width);
                    json.WriteNumber("height", _frame.Settings.Height);
                },
                _gone.Token).ConfigureAwait(false);
            return true;
        }
        catch (Exception exception) when (Problem.Of(exception) is not null)
        {
            await SendErrorAsync(exception, number: null).ConfigureAwait(false);
            return false;
        }
    }

    /// <summary>Draws the frame of a message and sends it, or what is wrong with it.</summary>
    private async Task AnswerAsync(StreamMessage message)
    {
        _number = message.Order + _numberOfFirst; // counts states that were left out too: the client knows which one this is
        try
        {
            (RequestedFrame requested, TrajectorySettings place) = message.Type == WebSocketMessageType.Binary
                ? (_frame!, WithNoise(PlaceOf(message.Bytes), _frame!))
                : ReadChanges(message);
            using Answer answer = _frames.Answers.InMemory(HeadLength);
            await _frames.DrawAsync(requested, place, _form, answer, _gone.Token).ConfigureAwait(false);
            if (_isTimed)
            {
                await SendTimesAsync(answer.Times).ConfigureAwait(false);
            }

            AnswerPart image = answer.Parts[0];
            WriteHead(image.Content.GetBuffer(), requested.Settings);
            await _socket.SendAsync(image.Bytes, _gone.Token).ConfigureAwait(false);
        }
        catch (Exception exception) when (Problem.Of(exception) is not null)
        {
            await SendErrorAsync(exception, _number).ConfigureAwait(false);
        }
    }

    private static FixedStateSettings PlaceOf(byte[] bytes)
    {
        if (bytes.Length != StateLength && bytes.Length != StateWithMotionLength)
        {
            throw new UsageException(
                $"the message has {bytes.Length} bytes; {StateLength} are needed: {string.Join(' ', SpacecraftState.NumberNames)} as "
                    + $"little-endian doubles; or {StateWithMotionLength} with the six numbers of --motion.");
        }

        double[] numbers = new double[bytes.Length / sizeof(double)];
        for (int index = 0; index < numbers.Length; index++)
        {
            numbers[index] = BinaryPrimitives.ReadDoubleLittleEndian(bytes.AsSpan(index * sizeof(double)));
        }

        return new FixedStateSettings(SpacecraftState.FromNumbers(numbers));
    }

    /// <summary>The options of the first message with those of a later one, which may give the frame's number too.</summary>
    private (RequestedFrame Requested, TrajectorySettings Place) ReadChanges(StreamMessage message)
    {
        using JsonDocument json = JsonText.Parse(message.Bytes);
        Dictionary<string, JsonElement> changes = new(JsonText.Members(json.RootElement), StringComparer.Ordinal);
        if (changes.Remove("number", out JsonElement number))
        {
            _number = number.ValueKind == JsonValueKind.Number && number.TryGetUInt32(out uint given)
                ? given
                : throw new UsageException("'number' is the frame's number, a whole number from 0 to 4294967295.");
            _numberOfFirst = _number - message.Order;
        }

        RequestedFrame requested = _frames.Read(_base, changes);
        bool hasOwnNoise = changes.ContainsKey(NativeOptions.NoiseSeed.Key);
        return (requested, hasOwnNoise ? requested.Place! : WithNoise(requested.Place!, requested));
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

    /// <summary>Says before an image how many ms it waited, and took to draw and to write.</summary>
    private Task SendTimesAsync(IReadOnlyList<(string Name, double Milliseconds)> times) => _socket.SendAsync(
        json =>
        {
            json.WriteNumber("number", _number);
            foreach ((string name, double milliseconds) in times)
            {
                json.WriteNumber(name, milliseconds);
            }
        },
        _gone.Token);

    private Task SendErrorAsync(Exception exception, uint? number) => _socket.SendAsync(
        json =>
        {
            if (number is { } known)
            {
                json.WriteNumber("number", known);
            }

            json.WriteString("error", Problem.Shortened(Problem.Of(exception)!.Detail));
        },
        _gone.Token);

    private static JsonElement FrameOf(IReadOnlyDictionary<string, JsonElement> members) =>
        members.TryGetValue("frame", out JsonElement frame)
            ? frame
            : throw new UsageException("the first message has no 'frame', the options of the images.");

    private static bool FlagOf(IReadOnlyDictionary<string, JsonElement> members, string name) =>
        members.TryGetValue(name, out JsonElement value)
        && value.ValueKind switch
        {
            JsonValueKind.True => true,
            JsonValueKind.False => false,
            _ => throw new UsageException($"'{name}' is {JsonText.Shown(value)}; true or false is needed."),
        };

    private static string WordOf(IReadOnlyDictionary<string, JsonElement> members, string name, params string[] words)
    {
        string word = members.TryGetValue(name, out JsonElement value) ? JsonText.Of(value, $"'{name}'") : words[0];
        return words.Contains(word)
            ? word
            : throw new UsageException($"'{name}' is '{word}'; one of {string.Join(", ", words)} is needed.");
    }
}
