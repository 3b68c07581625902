using System.Buffers.Text;
using System.Text;

namespace Msisf.Adapters.Metadata;

/// <summary>Writes text directly as bytes, piece by piece.</summary>
internal ref struct ByteText
{
    private readonly Span<byte> _destination;
    private readonly LongEDigits _digits;

    /// <summary>Begins at the destination's first byte.</summary>
    /// <param name="destination">Receives the text.</param>
    /// <param name="digits">Of the numbers in the longE format.</param>
    public ByteText(Span<byte> destination, LongEDigits digits)
    {
        _destination = destination;
        _digits = digits;
    }

    /// <summary>Bytes written.</summary>
    public int Length { get; private set; }

    public void Append(scoped ReadOnlySpan<byte> text)
    {
        text.CopyTo(_destination[Length..]);
        Length += text.Length;
    }

    /// <summary>Appends ASCII characters.</summary>
    public void Append(string ascii) => Length += Encoding.ASCII.GetBytes(ascii, _destination[Length..]);

    /// <summary>Appends a whole number.</summary>
    public void Append(int value)
    {
        Utf8Formatter.TryFormat(value, _destination[Length..], out int written);
        Length += written;
    }

    /// <summary>Appends a number.</summary>
    public void Append(double value) => Length += LongE.Write(value, _destination[Length..], _digits);
}
