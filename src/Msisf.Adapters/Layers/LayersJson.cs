using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Terrain;

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
            json.WriteNumber("mjdUtc", frame.SimulationTime.Mjd);
            json.WriteString("utc", frame.SimulationTime.ToIsoUtc());
            json.WriteString("frame", frame.Globe.Body.Frame);
            if (!frame.Globe.Body.IsMoon)
            {
                json.WriteString("body", frame.Globe.Body.Name);
                json.WriteNumber("referenceRadiusM", frame.Globe.ReferenceRadius);
            }

            json.WriteNumbers("cameraPositionM", frame.Camera.PositionBodyFixed);
            json.WriteNumbers("cameraQuaternionXyz0", orientation.X, orientation.Y, orientation.Z, orientation.W);
            json.WriteNumber("fieldOfViewDegrees", frame.FieldOfViewDegrees);
            json.WriteNumbers("sunPositionM", frame.SunPositionBodyFixed);
            json.WriteNumber("flightAltitudeM", frame.FlightAltitude);
            json.WriteNumber("heightOverTerrainM", frame.HeightOverTerrain);
            WriteCamera(json, CameraMatrix.Of(frame.Camera));
            json.WriteString("elevationModel", provenance.ElevationProduct);
            json.WriteBoolean("elevationModelIsSynthetic", frame.Elevation.IsSynthetic);
            if (provenance.InventedDetail is { } detail)
            {
                json.WriteString("inventedDetail", detail);
            }

            WriteResolution(json, "pixelsPerDegree", "metresPerPixel", frame.Elevation.Resolution);
            json.WriteNumber("levelOfDetail", provenance.LevelOfDetail);
            WriteResolution(json, "meshPixelsPerDegree", "meshMetresPerPixel", provenance.MeshResolution);
            InputsJson.Write(json, frame.Inputs);
            json.WriteStartArray("layers");
            foreach (Layer layer in layers.Layers)
            {
                json.WriteStartObject();
                json.WriteString("name", layer.Name);
                json.WriteString("unit", layer.Unit);
                json.WriteString("description", frame.Globe.Describe(layer.DescriptionOn(provenance.MeshResolution)));
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
    }

    private static void WriteCamera(Utf8JsonWriter json, CameraMatrix camera)
    {
        json.WriteNumber("width", camera.Width);
        json.WriteNumber("height", camera.Height);
        WriteRows(json, "K", camera.IntrinsicRows);
        WriteRows(json, "R", camera.RotationRows);
        json.WriteNumbers("t", camera.Translation);
        if (camera.Distortion is { } distortion)
        {
            json.WriteString("distortionModel", distortion.Name);
            json.WriteNumbers("distortion", distortion.Coefficients);
        }
    }

    private static void WriteRows(Utf8JsonWriter json, string name, IReadOnlyList<Vector3D> rows)
    {
        json.WriteStartArray(name);
        foreach (Vector3D row in rows)
        {
            json.WriteNumbers(row.X, row.Y, row.Z);
        }

        json.WriteEndArray();
    }

    /// <summary>The resolution by the key of its kind: px/deg of a grid of latitude and longitude, m/px of another.</summary>
    private static void WriteResolution(Utf8JsonWriter json, string degreeKey, string metreKey, GridResolution resolution)
    {
        if (resolution.PixelsPerDegree is { } pixelsPerDegree)
        {
            json.WriteNumber(degreeKey, pixelsPerDegree);
        }
        else
        {
            json.WriteNumber(metreKey, resolution.MetresPerPixel);
        }
    }
}
