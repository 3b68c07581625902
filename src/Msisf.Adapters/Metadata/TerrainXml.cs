using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Surface;

namespace Msisf.Adapters.Metadata;

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
