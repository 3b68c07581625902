using System.Buffers;
using System.Buffers.Binary;
using System.Buffers.Text;
using System.Numerics;

namespace Msisf.Adapters.Tiles;

/// <summary>Writes ASCII text and whole numbers to a stream through a buffer, without strings and cultures.</summary>
internal sealed class AsciiWriter : IDisposable
{
    /// <summary>More than the pattern of a part has, so that it is written by one call.</summary>
    private const int BufferBytes = 1 << 18;

    private const int LongestPiece = 64;

    private readonly Stream _output;
    private readonly long _start;
    private readonly byte[] _buffer = ArrayPool<byte>.Shared.Rent(BufferBytes);
    private int _used;
    private long _flushed;

    /// <summary>Starts at the stream's position.</summary>
    /// <param name="output">A stream that can seek.</param>
    public AsciiWriter(Stream output)
    {
        _output = output;
        _start = output.Position;
    }

    /// <summary>Bytes written so far.</summary>
    public long Length => _flushed + _used;

    /// <summary>The texts of the numbers from 0, each of up to eight digits, the first digit in the lowest byte.</summary>
    public static ulong[] TextsOfNumbers(int count)
    {
        ulong[] texts = new ulong[count];
        Span<byte> digits = stackalloc byte[sizeof(ulong)];
        for (int number = 0; number < count; number++)
        {
            digits.Clear();
            Utf8Formatter.TryFormat(number, digits, out _);
            texts[number] = BinaryPrimitives.ReadUInt64LittleEndian(digits);
        }

        return texts;
    }

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
        Add(number);
    }

    /// <summary>Writes a number of at least some digits, with leading zeros.</summary>
    public void Write(long number, byte digits)
    {
        Reserve();
        Utf8Formatter.TryFormat(number, _buffer.AsSpan(_used), out int written, new StandardFormat('D', digits));
        _used += written;
    }

    /// <summary>Writes three numbers as POV-Ray's vector.</summary>
    public void WriteVector(long a, long b, long c)
    {
        Reserve(); // three numbers of 64 bits and what is between them are 64 bytes
        Add((byte)'<');
        Add(a);
        Add((byte)',');
        Add(b);
        Add((byte)',');
        Add(c);
        Add((byte)'>');
    }

    /// <summary>The same of numbers whose texts are known (<see cref="TextsOfNumbers"/>).</summary>
    public void WriteVectorOfTexts(ulong a, ulong b, ulong c)
    {
        Reserve();
        Add((byte)'<');
        AddText(a);
        Add((byte)',');
        AddText(b);
        Add((byte)',');
        AddText(c);
        Add((byte)'>');
    }

    /// <summary>Writes a number over what was written before.</summary>
    /// <param name="position">Bytes that were written before that place.</param>
    /// <param name="digits">Its digits, with leading zeros.</param>
    public void WriteOver(long position, long number, byte digits)
    {
        if (position >= _flushed)
        {
            Utf8Formatter.TryFormat(number, _buffer.AsSpan((int)(position - _flushed)), out _, new StandardFormat('D', digits));
            return;
        }

        Flush();
        Span<byte> text = stackalloc byte[LongestPiece];
        Utf8Formatter.TryFormat(number, text, out int written, new StandardFormat('D', digits));
        _output.Position = _start + position;
        _output.Write(text[..written]);
        _output.Position = _start + Length;
    }

    /// <summary>Writes the buffer's content to the stream.</summary>
    public void Flush()
    {
        _output.Write(_buffer, 0, _used);
        _flushed += _used;
        _used = 0;
    }

    /// <summary>Gives the buffer back; what is not flushed is lost.</summary>
    public void Dispose() => ArrayPool<byte>.Shared.Return(_buffer);

    private void Add(byte character) => _buffer[_used++] = character;

    private void Add(long number)
    {
        Utf8Formatter.TryFormat(number, _buffer.AsSpan(_used), out int written);
        _used += written;
    }

    private void AddText(ulong text)
    {
        BinaryPrimitives.WriteUInt64LittleEndian(_buffer.AsSpan(_used), text);
        _used += sizeof(ulong) - (BitOperations.LeadingZeroCount(text) >> 3);
    }

    private void Reserve()
    {
        if (_used > BufferBytes - LongestPiece)
        {
            Flush();
        }
    }
}
