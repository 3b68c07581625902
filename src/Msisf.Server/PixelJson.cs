using System.Text.Json;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Surface;

namespace Msisf.Server;

/// <summary>Writes the pixels of a meta file as JSON, the same as <see cref="MetadataJson"/> makes of their elements.</summary>
internal static class PixelJson
{
    /// <summary>bytes: the writer's memory grows by doubling, and large pieces of memory are slow to get.</summary>
    private const int MostPending = 1 << 14;

    /// <summary>Writes what PixelInformation holds.</summary>
    /// <param name="pixels">Gives the pixels, by rows from the top.</param>
    public static void Write(Utf8JsonWriter json, PixelSampler pixels, CancellationToken cancellation)
    {
        PixelRecord[] row = new PixelRecord[pixels.Grid.Columns];
        bool hasPixels = false;
        for (int line = 0; line < pixels.Grid.Rows; line++)
        {
            cancellation.ThrowIfCancellationRequested();
            foreach (ref readonly PixelRecord record in row.AsSpan(0, pixels.SampleRow(line, row)))
            {
                if (!hasPixels)
                {
                    json.WriteStartObject();
                    json.WriteStartArray("Pixel"u8);
                    hasPixels = true;
                }

                Write(json, record);
                if (json.BytesPending > MostPending)
                {
                    json.Flush();
                }
            }
        }

        if (!hasPixels)
        {
            json.WriteStringValue(string.Empty);
            return;
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, in PixelRecord record)
    {
        json.WriteStartObject();
        json.WriteNumber("h"u8, record.H);
        json.WriteNumber("v"u8, record.V);
        json.WriteStartObject("SelenographicCoordinates"u8);
        Number(json, "lat"u8, double.RadiansToDegrees(record.Point.Latitude));
        Number(json, "lon"u8, double.RadiansToDegrees(record.Point.Longitude));
        json.WriteString("units"u8, "deg"u8);
        json.WriteEndObject();
        if (record.IlluminationDirection is { } direction)
        {
            Quantity(json, "IlluminationDirection"u8, "deg"u8, double.RadiansToDegrees(direction));
        }
        else
        {
            json.WriteStartObject("IlluminationDirection"u8);
            json.WriteString("unit"u8, "deg"u8);
            json.WriteString("defined"u8, "no"u8);
            json.WriteEndObject();
        }

        if (record.Terrain is { } terrain)
        {
            WriteTerrain(json, terrain);
        }

        json.WriteEndObject();
    }

    private static void WriteTerrain(Utf8JsonWriter json, in TerrainRecord terrain)
    {
        Quantity(json, "Height"u8, "m"u8, terrain.Height);
        json.WriteStartObject("Position"u8);
        json.WriteString("unit"u8, "m"u8);
        Vector(json, terrain.PositionBodyFixed);
        Quantity(json, "Range"u8, "m"u8, terrain.Range);
        json.WriteStartObject("Normal"u8);
        Vector(json, terrain.NormalBodyFixed);
        Quantity(json, "IncidenceAngle"u8, "deg"u8, double.RadiansToDegrees(terrain.Angles.Incidence));
        Quantity(json, "EmissionAngle"u8, "deg"u8, double.RadiansToDegrees(terrain.Angles.Emission));
        Quantity(json, "PhaseAngle"u8, "deg"u8, double.RadiansToDegrees(terrain.Angles.Phase));
        json.WriteStartObject("Illumination"u8);
        json.WriteString("state"u8, terrain.Light.State.Word());
        Number(json, "visibleFraction"u8, terrain.Light.VisibleFraction);
        json.WriteEndObject();
        json.WriteStartObject("Facet"u8);
        if (terrain.Tile is { } tile)
        {
            json.WriteString("tile"u8, tile.RangeText);
        }

        if (terrain.NamesPart)
        {
            json.WriteNumber("part"u8, terrain.Facet.Part);
        }

        json.WriteNumber("line"u8, terrain.Facet.Line);
        json.WriteNumber("sample"u8, terrain.Facet.Sample);
        json.WriteString("half"u8, terrain.Facet.Half == FacetHalf.SouthWest ? "SW"u8 : "NE"u8);
        json.WriteEndObject();
    }

    private static void Quantity(Utf8JsonWriter json, ReadOnlySpan<byte> name, ReadOnlySpan<byte> unit, double value)
    {
        json.WriteStartObject(name);
        json.WriteString("unit"u8, unit);
        Number(json, "value"u8, value);
        json.WriteEndObject();
    }

    /// <summary>A vector, and the end of the element that holds it.</summary>
    private static void Vector(Utf8JsonWriter json, Vector3D vector)
    {
        json.WriteStartObject("Vector3D"u8);
        Number(json, "x"u8, vector.X);
        Number(json, "y"u8, vector.Y);
        Number(json, "z"u8, vector.Z);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void Number(Utf8JsonWriter json, ReadOnlySpan<byte> name, double value) =>
        json.WriteNumber(name, value + 0.0); // -0 + 0 is 0, as in the XML
}
