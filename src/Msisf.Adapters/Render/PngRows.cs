using System.Buffers;
using System.IO.Compression;
using System.Numerics;

namespace Msisf.Adapters.Render;

/// <summary>Compresses the rows of a PNG as the difference from the row above, as many at once as fill the compressor's window.</summary>
internal sealed class PngRows : IDisposable
{
    private const byte UpFilter = 2;

    /// <summary>Bytes that go to the compressor at once, about: as much as its window.</summary>
    private const int BatchLength = 32768;

    private readonly PngDataStream _data;
    private readonly ZLibStream _compressor;
    private readonly int _rowLength;
    private readonly byte[] _batch;
    private readonly byte[] _above;
    private readonly int _batchEnd;
    private bool _isFirst = true;
    private int _used;

    /// <summary>Begins with the first row.</summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="rowLength">Bytes of a row.</param>
    /// <param name="compression">How it is compressed.</param>
    public PngRows(Stream destination, int rowLength, ZLibCompressionOptions compression)
    {
        _data = new PngDataStream(destination);
        _compressor = new ZLibStream(_data, compression);
        _rowLength = rowLength;
        _batchEnd = Math.Max(1, BatchLength / (rowLength + 1)) * (rowLength + 1);
        _batch = ArrayPool<byte>.Shared.Rent(_batchEnd);
        _above = ArrayPool<byte>.Shared.Rent(rowLength);
    }

    /// <summary>Adds the next rows.</summary>
    public void Add(ReadOnlySpan<byte> rows)
    {
        for (int start = 0; start < rows.Length; start += _rowLength)
        {
            ReadOnlySpan<byte> row = rows.Slice(start, _rowLength);
            ReadOnlySpan<byte> above = start > 0 ? rows.Slice(start - _rowLength, _rowLength)
                : _isFirst ? []
                : _above.AsSpan(0, _rowLength);
            _isFirst = false;
            _batch[_used] = UpFilter;
            Subtract(row, above, _batch.AsSpan(_used + 1, _rowLength));
            _used += _rowLength + 1;
            if (_used == _batchEnd)
            {
                _compressor.Write(_batch, 0, _used);
                _used = 0;
            }
        }

        if (rows.Length > 0)
        {
            rows[^_rowLength..].CopyTo(_above);
        }
    }

    /// <summary>Ends the image.</summary>
    public void Dispose()
    {
        _compressor.Write(_batch, 0, _used);
        _compressor.Dispose();
        _data.Dispose();
        ArrayPool<byte>.Shared.Return(_batch);
        ArrayPool<byte>.Shared.Return(_above);
    }

    /// <summary>Differences modulo 256; what is above the first row counts as 0.</summary>
    private static void Subtract(ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, Span<byte> difference)
    {
        if (above.IsEmpty)
        {
            row.CopyTo(difference);
            return;
        }

        int i = 0;
        for (; i <= row.Length - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            (new Vector<byte>(row[i..]) - new Vector<byte>(above[i..])).CopyTo(difference[i..]);
        }

        for (; i < row.Length; i++)
        {
            difference[i] = (byte)(row[i] - above[i]);
        }
    }
}

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
