using Msisf.App.Settings;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using System.Buffers.Binary;
using System.Net.WebSockets;

namespace Msisf.Server;

/// <summary>Messages of a WebSocket, each as a whole.</summary>
/// <param name="socket">The WebSocket.</param>
/// <param name="usualLength">bytes: room for a message at first.</param>
internal sealed class StreamSocket(WebSocket socket, int usualLength)
{
    private const int LargestMessage = 1 << 16;

    private uint _received;

    /// <summary>The next message; null if the client closes, or sends more than a message may hold.</summary>
    public async Task<StreamMessage?> ReceiveAsync(CancellationToken cancellation)
    {
        byte[] buffer = new byte[usualLength];
        int length = 0;
        while (true)
        {
            ValueWebSocketReceiveResult part = await socket.ReceiveAsync(buffer.AsMemory(length), cancellation).ConfigureAwait(false);
            length += part.Count;
            if (part.MessageType == WebSocketMessageType.Close)
            {
                return null;
            }

            if (part.EndOfMessage)
            {
                return new StreamMessage(part.MessageType, buffer[..length], _received++);
            }

            if (length == LargestMessage)
            {
                await CloseAsync(WebSocketCloseStatus.MessageTooBig, $"a message has {LargestMessage} bytes at most", cancellation)
                    .ConfigureAwait(false);
                return null;
            }

            if (length == buffer.Length)
            {
                Array.Resize(ref buffer, Math.Min(LargestMessage, 4 * buffer.Length));
            }
        }
    }

    /// <summary>Sends a binary message.</summary>
    public Task SendAsync(ReadOnlyMemory<byte> message, CancellationToken cancellation) =>
        SendAsync(message, WebSocketMessageType.Binary, cancellation);

    /// <summary>Sends a JSON object.</summary>
    public Task SendJsonAsync<T>(T value, CancellationToken cancellation) =>
        SendAsync(JsonBody.ToBytes(value), WebSocketMessageType.Text, cancellation);

    /// <summary>Says that nothing more comes, if the client can still hear it.</summary>
    public async Task CloseAsync(WebSocketCloseStatus status, string reason, CancellationToken cancellation)
    {
        if (socket.State is WebSocketState.Open or WebSocketState.CloseReceived)
        {
            await socket.CloseOutputAsync(status, reason, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>Ends the connection at once.</summary>
    public void Abort() => socket.Abort();

    /// <summary>A client that does not read is given up.</summary>
    private async Task SendAsync(ReadOnlyMemory<byte> message, WebSocketMessageType type, CancellationToken cancellation)
    {
        using CancellationTokenSource late = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        late.CancelAfter(ResponseStream.LongestWrite);
        await socket.SendAsync(message, type, endOfMessage: true, late.Token).ConfigureAwait(false);
    }
}

/// <summary>A message of a client.</summary>
/// <param name="Type">Binary for a state, text for JSON.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="Order">Which one of the stream's messages it is; 0 for the first.</param>
internal sealed record StreamMessage(WebSocketMessageType Type, byte[] Bytes, uint Order)
{
    /// <summary>bytes: eight doubles with the six of a motion.</summary>
    public const int StateWithMotionLength = 112;

    private const int StateLength = 64;

    /// <summary>The state of a binary message.</summary>
    public FixedStateSettings ToPlace()
    {
        if (Bytes.Length != StateLength && Bytes.Length != StateWithMotionLength)
        {
            throw new UsageException(
                $"the message has {Bytes.Length} bytes; {StateLength} are needed: {string.Join(' ', SpacecraftState.NumberNames)} as "
                    + $"little-endian doubles; or {StateWithMotionLength} with the six numbers of --motion.");
        }

        double[] numbers = new double[Bytes.Length / sizeof(double)];
        for (int index = 0; index < numbers.Length; index++)
        {
            numbers[index] = BinaryPrimitives.ReadDoubleLittleEndian(Bytes.AsSpan(index * sizeof(double)));
        }

        return new FixedStateSettings(CalendarTime.OfMjd(numbers[0]), SpacecraftState.FromNumbers(default, numbers.AsSpan(1)));
    }
}
