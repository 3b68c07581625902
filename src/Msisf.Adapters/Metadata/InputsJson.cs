using System.Text.Json;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>Names the files that something was made from, as meta files do.</summary>
internal static class InputsJson
{
    /// <summary>Writes the property <c>inputs</c>.</summary>
    public static void Write(Utf8JsonWriter json, IReadOnlyList<InputFile> inputs)
    {
        json.WriteStartArray("inputs");
        foreach (InputFile input in inputs)
        {
            json.WriteStartObject();
            json.WriteString("kind", OriginXml.WordOf(input.Kind));
            json.WriteString("name", input.Name);
            json.WriteNumber("bytes", input.Bytes);
            json.WriteString(input.IsOfPieces ? OriginXml.PiecesChecksum : OriginXml.Checksum, input.Sha256);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }
}
