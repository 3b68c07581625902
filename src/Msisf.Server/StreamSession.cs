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
    private const int LargestMessage = 1 << 16;

    /// <summary>Messages that are read ahead in lock-step.</summary>
    private const int Ahead = 16;

    private static ReadOnlySpan<byte> Magic => "MSIF"u8;

    private readonly FrameService _frames;
    private readonly WebSocket _socket;
    private readonly CancellationTokenSource _gone;
    private readonly CancellationToken _stopping;
    private JsonDocument? _opening;
    private AnswerForm _form = AnswerForm.Of(AnswerForm.Raw);
    private RequestedFrame? _frame;
    private JsonElement _base;
    private uint _number;
    private bool _isNewestOnly;

    public StreamSession(FrameService frames, WebSocket socket, CancellationToken aborted, CancellationToken stopping)
    {
        (_frames, _socket, _stopping) = (frames, socket, stopping);
        _gone = CancellationTokenSource.CreateLinkedTokenSource(aborted);
    }

    /// <summary>Serves the socket until it is closed.</summary>
    public async Task RunAsync()
    {
        try
        {
            if (await ReceiveAsync(_gone.Token).ConfigureAwait(false) is not { } first || !await OpenAsync(first).ConfigureAwait(false))
            {
                await CloseAsync(WebSocketCloseStatus.PolicyViolation, "the first message says the frame").ConfigureAwait(false);
                return;
            }

            Channel<StreamMessage> messages = Channel.CreateBounded<StreamMessage>(new BoundedChannelOptions(_isNewestOnly ? 1 : Ahead)
            {
                FullMode = _isNewestOnly ? BoundedChannelFullMode.DropOldest : BoundedChannelFullMode.Wait,
                SingleReader = true,
                SingleWriter = true,
            });
            Task reading = ReadAsync(messages.Writer);
            await foreach (StreamMessage message in messages.Reader.ReadAllAsync(_gone.Token).ConfigureAwait(false))
            {
                await AnswerAsync(message).ConfigureAwait(false);
                if (_stopping.IsCancellationRequested)
                {
                    break;
                }
            }

            await CloseAsync(
                _stopping.IsCancellationRequested ? WebSocketCloseStatus.EndpointUnavailable : WebSocketCloseStatus.NormalClosure,
                "end").ConfigureAwait(false);
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

    /// <summary>Reads the first message.</summary>
    /// <returns>Whether the session can begin; the client has been told.</returns>
    private async Task<bool> OpenAsync(StreamMessage first)
    {
        try
        {
            _opening = JsonDocument.Parse(first.Bytes);
            IReadOnlyDictionary<string, JsonElement> members = JsonText.Members(_opening.RootElement);
            if (members.Keys.FirstOrDefault(key => key is not ("frame" or "mode" or "format")) is { } unknown)
            {
                throw new UsageException($"'{unknown}' is not known here; the first message has 'frame', 'mode' and 'format'.");
            }

            _isNewestOnly = WordOf(members, "mode", "lock-step", "newest-only") == "newest-only";
            _form = AnswerForm.Of(WordOf(members, "format", "u8", "png") == "png" ? AnswerForm.Png : AnswerForm.Raw);
            _base = FrameOf(members);
            _frame = _frames.Read(_base, needsPlace: false);
            await SendAsync(json =>
            {
                json.WriteBoolean("ready", true);
                json.WriteNumber("width", _frame.Settings.Width);
                json.WriteNumber("height", _frame.Settings.Height);
            }).ConfigureAwait(false);
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
        _number++;
        try
        {
            (RequestedFrame requested, CameraSettings place) = message.Type == WebSocketMessageType.Binary
                ? (_frame!, PlaceOf(message.Bytes))
                : ReadChanges(message.Bytes);
            using Answer answer = await _frames.DrawAsync(requested, place, _form, _gone.Token).ConfigureAwait(false);
            byte[] head = new byte[HeadLength];
            Magic.CopyTo(head);
            BinaryPrimitives.WriteUInt32LittleEndian(head.AsSpan(4), _number);
            BinaryPrimitives.WriteUInt32LittleEndian(head.AsSpan(8), (uint)requested.Settings.Width);
            BinaryPrimitives.WriteUInt32LittleEndian(head.AsSpan(12), (uint)requested.Settings.Height);
            await _socket.SendAsync(head, WebSocketMessageType.Binary, endOfMessage: false, _gone.Token).ConfigureAwait(false);
            await _socket.SendAsync(answer.Parts[0].Bytes, WebSocketMessageType.Binary, endOfMessage: true, _gone.Token)
                .ConfigureAwait(false);
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
    private (RequestedFrame Requested, CameraSettings Place) ReadChanges(byte[] text)
    {
        using JsonDocument json = JsonDocument.Parse(text);
        Dictionary<string, JsonElement> changes = new(JsonText.Members(json.RootElement), StringComparer.Ordinal);
        if (changes.Remove("number", out JsonElement number))
        {
            _number = number.ValueKind == JsonValueKind.Number && number.TryGetUInt32(out uint given)
                ? given
                : throw new UsageException("'number' is the frame's number, a whole number from 0 to 4294967295.");
        }

        RequestedFrame requested = _frames.Read(_base, changes);
        return (requested, requested.Place!);
    }

    /// <summary>Reads messages ahead, so that it is noticed when the client goes away.</summary>
    private async Task ReadAsync(ChannelWriter<StreamMessage> messages)
    {
        try
        {
            while (await ReceiveAsync(_gone.Token).ConfigureAwait(false) is { } message)
            {
                await messages.WriteAsync(message, _gone.Token).ConfigureAwait(false);
            }

            messages.Complete();
        }
        catch (Exception exception) when (exception is WebSocketException or OperationCanceledException)
        {
            await _gone.CancelAsync().ConfigureAwait(false);
            messages.TryComplete(exception);
        }
    }

    /// <summary>The next message; null if the client closes, or sends more than a message may hold.</summary>
    private async Task<StreamMessage?> ReceiveAsync(CancellationToken cancellation)
    {
        byte[] buffer = new byte[StateWithMotionLength];
        int length = 0;
        while (true)
        {
            ValueWebSocketReceiveResult part = await _socket.ReceiveAsync(buffer.AsMemory(length), cancellation).ConfigureAwait(false);
            length += part.Count;
            if (part.MessageType == WebSocketMessageType.Close)
            {
                return null;
            }

            if (part.EndOfMessage)
            {
                return new StreamMessage(part.MessageType, buffer[..length]);
            }

            if (length == LargestMessage)
            {
                await CloseAsync(WebSocketCloseStatus.MessageTooBig, $"a message has {LargestMessage} bytes at most").ConfigureAwait(false);
                return null;
            }

            if (length == buffer.Length)
            {
                Array.Resize(ref buffer, Math.Min(LargestMessage, 4 * buffer.Length));
            }
        }
    }

    private Task SendErrorAsync(Exception exception, uint? number) => SendAsync(json =>
    {
        if (number is { } known)
        {
            json.WriteNumber("number", known);
        }

        json.WriteString("error", Problem.Of(exception)!.Detail);
    });

    private async Task SendAsync(Action<Utf8JsonWriter> write)
    {
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream, JsonBody.Writing))
        {
            json.WriteStartObject();
            write(json);
            json.WriteEndObject();
        }

        await _socket.SendAsync(stream.ToArray(), WebSocketMessageType.Text, endOfMessage: true, _gone.Token).ConfigureAwait(false);
    }

    private async Task CloseAsync(WebSocketCloseStatus status, string reason)
    {
        if (_socket.State is WebSocketState.Open or WebSocketState.CloseReceived)
        {
            await _socket.CloseOutputAsync(status, reason, _gone.Token).ConfigureAwait(false);
        }
    }

    private static JsonElement FrameOf(IReadOnlyDictionary<string, JsonElement> members) => members.TryGetValue("frame", out JsonElement frame)
        ? frame
        : throw new UsageException("the first message has no 'frame', the options of the images.");

    private static string WordOf(IReadOnlyDictionary<string, JsonElement> members, string name, params string[] words)
    {
        string word = members.TryGetValue(name, out JsonElement value) ? JsonText.Of(value, $"'{name}'") : words[0];
        return words.Contains(word)
            ? word
            : throw new UsageException($"'{name}' is '{word}'; one of {string.Join(", ", words)} is needed.");
    }
}
