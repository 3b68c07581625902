using System.Buffers.Text;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>One Pixel element, written straight into bytes: a picture can have hundreds of millions of them.</summary>
internal static class PixelXml
{
    /// <summary>No Pixel element is longer: 161 bytes of markup, two whole numbers, three longE numbers.</summary>
    public const int MaximumLength = 161 + (2 * 10) + (3 * LongE.Length);

    /// <summary>Writes the element of a record.</summary>
    /// <param name="record">The pixel.</param>
    /// <param name="destination">At least <see cref="MaximumLength"/> bytes.</param>
    /// <returns>How many bytes there are.</returns>
    public static int Write(in PixelRecord record, Span<byte> destination)
    {
        int length = 0;
        Append("    <Pixel h=\""u8, destination, ref length);
        Append(record.H, destination, ref length);
        Append("\" v=\""u8, destination, ref length);
        Append(record.V, destination, ref length);
        Append("\">\n      <SelenographicCoordinates lat=\""u8, destination, ref length);
        Append(double.RadiansToDegrees(record.Point.Latitude), destination, ref length);
        Append("\" lon=\""u8, destination, ref length);
        Append(double.RadiansToDegrees(record.Point.Longitude), destination, ref length);
        Append("\" units=\"deg\" />\n      <IlluminationDirection unit=\"deg\""u8, destination, ref length);
        if (record.IlluminationDirection is double direction)
        {
            Append(">"u8, destination, ref length);
            Append(double.RadiansToDegrees(direction), destination, ref length);
            Append("</IlluminationDirection>\n    </Pixel>\n"u8, destination, ref length);
        }
        else
        {
            Append(" defined=\"no\" />\n    </Pixel>\n"u8, destination, ref length);
        }

        return length;
    }

    private static void Append(ReadOnlySpan<byte> text, Span<byte> destination, ref int length)
    {
        text.CopyTo(destination[length..]);
        length += text.Length;
    }

    private static void Append(int value, Span<byte> destination, ref int length)
    {
        Utf8Formatter.TryFormat(value, destination[length..], out int written);
        length += written;
    }

    private static void Append(double value, Span<byte> destination, ref int length)
    {
        LongE.Write(value, destination[length..]);
        length += LongE.Length;
    }
}
