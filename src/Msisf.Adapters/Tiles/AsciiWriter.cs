using System.Buffers.Text;

namespace Msisf.Adapters.Tiles;

/// <summary>Writes ASCII text and whole numbers to a stream through a buffer, without strings and cultures.</summary>
internal sealed class AsciiWriter
{
    private const int BufferBytes = 65536;
    private const int LongestPiece = 64;

    private readonly Stream _output;
    private readonly byte[] _buffer = new byte[BufferBytes];
    private int _used;
    private long _flushed;

    /// <summary>Starts at the stream's position.</summary>
    public AsciiWriter(Stream output) => _output = output;

    /// <summary>Bytes written so far.</summary>
    public long Length => _flushed + _used;

    /// <summary>Writes text; a "..."u8 literal of up to 64 bytes, or longer bytes.</summary>
    public void Write(ReadOnlySpan<byte> text)
    {
        while (text.Length > LongestPiece)
        {
            Write(text[..LongestPiece]);
            text = text[LongestPiece..];
        }

        Reserve();
        text.CopyTo(_buffer.AsSpan(_used));
        _used += text.Length;
    }

    /// <summary>Writes a number without leading zeros, '-' if it is negative.</summary>
    public void Write(long number)
    {
        Reserve();
        Utf8Formatter.TryFormat(number, _buffer.AsSpan(_used), out int written);
        _used += written;
    }

    /// <summary>Writes a number of at least some digits, with leading zeros.</summary>
    public void Write(long number, byte digits)
    {
        Reserve();
        Utf8Formatter.TryFormat(number, _buffer.AsSpan(_used), out int written, new System.Buffers.StandardFormat('D', digits));
        _used += written;
    }

    /// <summary>Writes three numbers as POV-Ray's vector.</summary>
    public void WriteVector(long a, long b, long c)
    {
        Write("<"u8);
        Write(a);
        Write(","u8);
        Write(b);
        Write(","u8);
        Write(c);
        Write(">"u8);
    }

    /// <summary>Writes the buffer's content to the stream.</summary>
    public void Flush()
    {
        _output.Write(_buffer, 0, _used);
        _flushed += _used;
        _used = 0;
    }

    private void Reserve()
    {
        if (_used > BufferBytes - LongestPiece)
        {
            Flush();
        }
    }
}
