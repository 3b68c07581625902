using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace Msisf.Adapters.Manifest;

/// <summary>The text of a manifest's lines.</summary>
internal static class ManifestLine
{
    private const int Sha256Digits = 64;

    private static readonly JsonWriterOptions Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The line of a record, UTF-8, with its LF. The same record gives the same bytes.</summary>
    public static byte[] Write(ManifestRecord record)
    {
        ArrayBufferWriter<byte> buffer = new();
        using (Utf8JsonWriter json = new(buffer, Plain))
        {
            json.WriteStartObject();
            switch (record)
            {
                case SettingsRecord settings:
                    json.WriteString("record", "settings");
                    json.WriteString("settings", settings.Key);
                    json.WritePropertyName("description");
                    json.WriteRawValue(settings.Description);
                    break;
                case RunRecord run:
                    json.WriteString("record", "run");
                    json.WriteString("run", run.Run);
                    json.WriteString("settings", run.Settings);
                    json.WriteNumber("frames", run.Frames);
                    break;
                case ExpectedRecord expected:
                    json.WriteString("record", "expected");
                    json.WriteString("run", expected.Run);
                    WriteFrame(json, expected.Step, expected.Name, expected.Frame);
                    break;
                case FrameRecord frame:
                    json.WriteString("record", "frame");
                    WriteFrame(json, frame.Step, frame.Name, frame.Frame);
                    json.WriteString("settings", frame.Settings);
                    WriteFiles(json, frame.Files);
                    break;
                case FailedRecord failed:
                    json.WriteString("record", "failed");
                    WriteFrame(json, failed.Step, failed.Name, failed.Frame);
                    json.WriteString("cause", failed.Cause);
                    break;
                case SharedFileRecord shared:
                    json.WriteString("record", "shared");
                    WriteFiles(json, [shared.File]);
                    break;
                default:
                    throw new ArgumentOutOfRangeException(nameof(record), record, "no record of a manifest");
            }

            json.WriteEndObject();
        }

        buffer.Write("\n"u8);
        return buffer.WrittenSpan.ToArray();
    }

    /// <summary>Reads a line.</summary>
    /// <param name="line">Without its LF.</param>
    /// <returns>Null if it is none of a manifest.</returns>
    public static ManifestRecord? TryRead(ReadOnlyMemory<byte> line)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(line);
            return Read(document.RootElement);
        }
        catch (Exception exception) when (
            exception is JsonException or KeyNotFoundException or InvalidOperationException or FormatException)
        {
            return null;
        }
    }

    private static ManifestRecord? Read(JsonElement line) => Text(line, "record") switch
    {
        "settings" => new SettingsRecord(
            Text(line, "settings"),
            line.GetProperty("description") is { ValueKind: JsonValueKind.Object } description
                ? description.GetRawText()
                : throw new FormatException()),
        "run" => new RunRecord(Text(line, "run"), Text(line, "settings"), Step(line, "frames")),
        "expected" => new ExpectedRecord(Text(line, "run"), Step(line, "step"), Name(line), Text(line, "frame")),
        "frame" => new FrameRecord(Step(line, "step"), Name(line), Text(line, "frame"), Text(line, "settings"), Files(line)),
        "shared" => Files(line) is [{ } only] ? new SharedFileRecord(only) : throw new FormatException(),
        "failed" => new FailedRecord(Step(line, "step"), Name(line), Text(line, "frame"), Text(line, "cause")),
        _ => null,
    };

    private static void WriteFrame(Utf8JsonWriter json, int step, string name, string key)
    {
        json.WriteNumber("step", step);
        json.WriteString("name", name);
        json.WriteString("frame", key);
    }

    private static void WriteFiles(Utf8JsonWriter json, IReadOnlyList<OutputFile> files)
    {
        json.WriteStartArray("files");
        foreach (OutputFile file in files)
        {
            json.WriteStartObject();
            json.WriteString("name", file.Name);
            json.WriteNumber("bytes", file.Bytes);
            json.WriteString("sha256", file.Sha256);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static OutputFile[] Files(JsonElement line)
    {
        OutputFile[] files = [.. line.GetProperty("files").EnumerateArray().Select(file => new OutputFile(
            Name(file), file.GetProperty("bytes").GetInt64(), Text(file, "sha256")))];
        return files.Length > 0 && files.All(file => file.Bytes >= 0 && file.Sha256.Length == Sha256Digits)
            ? files
            : throw new FormatException();
    }

    /// <summary>A file name without a folder, which could lead out of the outputs' folder.</summary>
    private static string Name(JsonElement line) =>
        Text(line, "name") is { Length: > 0 } name && name is not ("." or "..") && name.AsSpan().IndexOfAny('/', '\\', '\0') < 0
            ? name
            : throw new FormatException();

    private static int Step(JsonElement line, string property) =>
        line.GetProperty(property).GetInt32() is > 0 and int step ? step : throw new FormatException();

    private static string Text(JsonElement line, string property) => line.GetProperty(property).GetString() ?? throw new FormatException();
}
