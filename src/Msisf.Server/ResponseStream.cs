using System.Buffers;

namespace Msisf.Server;

/// <summary>The body of an answer. It goes out piece by piece; a client that does not take a piece in time loses the connection.</summary>
/// <param name="body">The server's stream; a write to it that is cancelled ends the connection.</param>
/// <param name="longestWrite">The longest that a client may take for a piece.</param>
internal sealed class ResponseStream(Stream body, TimeSpan longestWrite) : Stream
{
    /// <summary>
    /// bytes: a client that takes this much in the time of a write is slow, but not gone. An image of 1 MiB in pieces of 64 KiB takes twice
    /// as long, because each of them wakes the thread that sends.
    /// </summary>
    private const int Piece = 1 << 18;

    /// <summary>The longest that clients of the server may take for a piece.</summary>
    public static readonly TimeSpan LongestWrite = TimeSpan.FromSeconds(30);

    /// <summary>Stops writes that block.</summary>
    public CancellationToken Stop { get; set; }

    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override async ValueTask WriteAsync(ReadOnlyMemory<byte> buffer, CancellationToken cancellationToken = default)
    {
        using CancellationTokenSource late = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        for (; !buffer.IsEmpty; buffer = buffer[Math.Min(Piece, buffer.Length)..])
        {
            late.CancelAfter(longestWrite);
            await body.WriteAsync(buffer[..Math.Min(Piece, buffer.Length)], late.Token).ConfigureAwait(false);
        }
    }

    public override Task WriteAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        WriteAsync(buffer.AsMemory(offset, count), cancellationToken).AsTask();

    /// <summary>Blocks until the client has taken all but what the system keeps for it.</summary>
    public override void Write(ReadOnlySpan<byte> buffer)
    {
        byte[] piece = ArrayPool<byte>.Shared.Rent(Math.Min(Piece, buffer.Length));
        while (!buffer.IsEmpty)
        {
            int length = Math.Min(Piece, buffer.Length);
            buffer[..length].CopyTo(piece);
            WriteAsync(piece.AsMemory(0, length), Stop).AsTask().GetAwaiter().GetResult();
            buffer = buffer[length..];
        }

        ArrayPool<byte>.Shared.Return(piece);
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    public override Task FlushAsync(CancellationToken cancellationToken) => body.FlushAsync(cancellationToken);

    /// <summary>Nothing: what is written goes on its way at once.</summary>
    public override void Flush()
    {
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();
}
