namespace Msisf.Adapters.Render;

/// <summary>
/// Writes what comes in as IDAT chunks of a PNG file, so that the compressed image need not be held. Leaves the file open.
/// </summary>
internal sealed class PngDataStream(Stream file) : Stream
{
    private const int ChunkLength = 65536;

    private readonly byte[] _chunk = new byte[ChunkLength];
    private int _length;

    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        while (buffer.Length > 0)
        {
            int taken = Math.Min(buffer.Length, ChunkLength - _length);
            buffer[..taken].CopyTo(_chunk.AsSpan(_length));
            buffer = buffer[taken..];
            _length += taken;
            if (_length == ChunkLength)
            {
                WriteChunk();
            }
        }
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    /// <summary>Does nothing: chunks are full but for the last one, whenever the compressor flushes.</summary>
    public override void Flush()
    {
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        if (disposing && _length > 0)
        {
            WriteChunk();
        }

        base.Dispose(disposing);
    }

    private void WriteChunk()
    {
        PngChunk.Write(file, "IDAT"u8, _chunk.AsSpan(0, _length));
        _length = 0;
    }
}
