using System.Buffers.Text;
using System.Text;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Surface;

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
    /// <param name="digits">Digits of the numbers.</param>
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

/// <summary>The elements that a Pixel has on the terrain only.</summary>
internal static class TerrainXml
{
    /// <summary>
    /// Bytes of the longest content: 431 bytes of markup, the longest state, tile and half; three whole numbers, twelve longE numbers.
    /// </summary>
    public const int MaximumLength = 431 + 8 + 23 + 2 + (3 * 10) + (12 * LongE.MaximumLength);

    /// <summary>Writes the elements.</summary>
    /// <param name="terrain">The terrain point.</param>
    /// <param name="text">Receives at most <see cref="MaximumLength"/> bytes.</param>
    public static void Write(in TerrainRecord terrain, ref ByteText text)
    {
        text.Append("      <Height unit=\"m\">"u8);
        text.Append(terrain.Height);
        text.Append("</Height>\n      <Position unit=\"m\">"u8);
        Append(terrain.PositionBodyFixed, ref text);
        text.Append("</Position>\n      <Range unit=\"m\">"u8);
        text.Append(terrain.Range);
        text.Append("</Range>\n      <Normal>"u8);
        Append(terrain.NormalBodyFixed, ref text);
        text.Append("</Normal>\n      <IncidenceAngle unit=\"deg\">"u8);
        text.Append(double.RadiansToDegrees(terrain.Angles.Incidence));
        text.Append("</IncidenceAngle>\n      <EmissionAngle unit=\"deg\">"u8);
        text.Append(double.RadiansToDegrees(terrain.Angles.Emission));
        text.Append("</EmissionAngle>\n      <PhaseAngle unit=\"deg\">"u8);
        text.Append(double.RadiansToDegrees(terrain.Angles.Phase));
        text.Append("</PhaseAngle>\n      <Illumination state=\""u8);
        text.Append(terrain.Light.State.Word());
        text.Append("\" visibleFraction=\""u8);
        text.Append(terrain.Light.VisibleFraction);
        text.Append("\" />\n      <Facet"u8);
        if (terrain.Tile is { } tile)
        {
            text.Append(" tile=\""u8);
            text.Append(tile.RangeText);
            text.Append("\""u8);
        }

        if (terrain.NamesPart)
        {
            text.Append(" part=\""u8);
            text.Append(terrain.Facet.Part);
            text.Append("\""u8);
        }

        text.Append(" line=\""u8);
        text.Append(terrain.Facet.Line);
        text.Append("\" sample=\""u8);
        text.Append(terrain.Facet.Sample);
        text.Append("\" half=\""u8);
        text.Append(terrain.Facet.Half == FacetHalf.SouthWest ? "SW"u8 : "NE"u8);
        text.Append("\" />\n"u8);
    }

    private static void Append(Vector3D v, ref ByteText text)
    {
        text.Append("<Vector3D x=\""u8);
        text.Append(v.X);
        text.Append("\" y=\""u8);
        text.Append(v.Y);
        text.Append("\" z=\""u8);
        text.Append(v.Z);
        text.Append("\" />"u8);
    }
}

/// <summary>Writes text directly as bytes, piece by piece.</summary>
internal ref struct ByteText
{
    private readonly Span<byte> _destination;
    private readonly LongEDigits _digits;

    /// <summary>Begins at the destination's first byte.</summary>
    /// <param name="destination">Receives the text.</param>
    /// <param name="digits">Digits of the numbers in the longE format.</param>
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
