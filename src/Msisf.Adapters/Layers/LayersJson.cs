using System.Text.Json;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;

namespace Msisf.Adapters.Layers;

/// <summary>Writes the provenance of array files, which have no place for it. Numbers read back to the bit.</summary>
internal static class LayersJson
{
    private static readonly JsonWriterOptions Indented = new() { Indented = true, NewLine = "\n" };

    public static void Write(Stream stream, FrameMetadata frame, LayerProvenance provenance, LayerSet layers)
    {
        UnitQuaternion orientation = frame.Camera.MoonFromCamera;
        using (Utf8JsonWriter json = new(stream, Indented))
        {
            json.WriteStartObject();
            json.WriteString("version", frame.Version);
            json.WriteString("commandLine", frame.CommandLine);
            json.WriteString("renderer", provenance.Renderer);
            json.WriteNumber("mjdUtc", frame.SimulationTime.Days);
            json.WriteString("utc", frame.SimulationTime.ToIsoUtc());
            json.WriteString("frame", "MOON_ME");
            WriteNumbers(
                json, "cameraPositionM", frame.Camera.PositionMoonMe.X, frame.Camera.PositionMoonMe.Y, frame.Camera.PositionMoonMe.Z);
            WriteNumbers(json, "cameraQuaternionXyz0", orientation.X, orientation.Y, orientation.Z, orientation.W);
            json.WriteNumber("fieldOfViewDegrees", frame.FieldOfViewDegrees);
            WriteNumbers(json, "sunPositionM", frame.SunPositionMoonMe.X, frame.SunPositionMoonMe.Y, frame.SunPositionMoonMe.Z);
            json.WriteString("elevationModel", provenance.ElevationProduct);
            json.WriteNumber("pixelsPerDegree", frame.PixelsPerDegree);
            json.WriteNumber("levelOfDetail", provenance.LevelOfDetail);
            json.WriteNumber("meshPixelsPerDegree", provenance.MeshPixelsPerDegree);
            json.WriteStartArray("layers");
            foreach (Layer layer in layers.Layers)
            {
                json.WriteStartObject();
                json.WriteString("name", layer.Name);
                json.WriteString("unit", layer.Unit);
                json.WriteString("description", layer.Description);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
    }

    private static void WriteNumbers(Utf8JsonWriter json, string name, params ReadOnlySpan<double> numbers)
    {
        json.WriteStartArray(name);
        foreach (double number in numbers)
        {
            json.WriteNumberValue(number);
        }

        json.WriteEndArray();
    }
}
