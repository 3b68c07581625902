using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>Writes a Pixel element directly as bytes: an image can have hundreds of millions of them.</summary>
internal static class PixelXml
{
    /// <summary>
    /// Bytes of the longest Pixel element on the reference sphere: 161 bytes of markup, two whole numbers, three longE numbers.
    /// </summary>
    private const int MaximumLengthOnSphere = 161 + (2 * 10) + (3 * LongE.MaximumLength);

    /// <summary>No Pixel element is longer.</summary>
    public static int MaximumLength(PixelSurface surface) =>
        surface == PixelSurface.Terrain ? MaximumLengthOnSphere + TerrainXml.MaximumLength : MaximumLengthOnSphere;

    /// <summary>Writes the element of a record.</summary>
    /// <param name="destination">At least <see cref="MaximumLength"/> bytes.</param>
    /// <param name="digits">Of the numbers.</param>
    /// <returns>How many bytes there are.</returns>
    public static int Write(in PixelRecord record, Span<byte> destination, LongEDigits digits = LongEDigits.Thesis)
    {
        ByteText text = new(destination, digits);
        text.Append("    <Pixel h=\""u8);
        text.Append(record.H);
        text.Append("\" v=\""u8);
        text.Append(record.V);
        text.Append("\">\n      <SelenographicCoordinates lat=\""u8);
        text.Append(double.RadiansToDegrees(record.Point.Latitude));
        text.Append("\" lon=\""u8);
        text.Append(double.RadiansToDegrees(record.Point.Longitude));
        text.Append("\" units=\"deg\" />\n      <IlluminationDirection unit=\"deg\""u8);
        if (record.IlluminationDirection is double direction)
        {
            text.Append(">"u8);
            text.Append(double.RadiansToDegrees(direction));
            text.Append("</IlluminationDirection>\n"u8);
        }
        else
        {
            text.Append(" defined=\"no\" />\n"u8);
        }

        if (record.Terrain is TerrainRecord terrain)
        {
            TerrainXml.Write(terrain, ref text);
        }

        text.Append("    </Pixel>\n"u8);
        return text.Length;
    }
}
