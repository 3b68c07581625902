using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings;
using Msisf.Core.Metadata;

namespace Msisf.App.Series;

/// <summary>
/// Everything except the states that determines the frames of a run: runs with equal identities and states have identical files on any
/// computer.
/// </summary>
/// <param name="Version">Version of the program.</param>
/// <param name="Arguments">Arguments of the frames as text; see <see cref="FrameArguments.OfSettings"/>.</param>
/// <param name="Record">The same settings as a record of the manifest, with checksums of the inputs.</param>
internal sealed record RunIdentity(string Version, string Arguments, SettingsRecord Record)
{
    /// <summary>Length of a key, hexadecimal digits: half of a SHA-256 hash.</summary>
    private const int KeyLength = 32;

    /// <param name="arguments">Arguments of the frames as text; see <see cref="FrameArguments.OfSettings"/>.</param>
    /// <param name="engine">Name and version of the ephemeris engine; null if the Sun is ignored.</param>
    /// <param name="kernels">The kernels, in load order.</param>
    /// <param name="povRay">Version of POV-Ray; null if POV-Ray is not used.</param>
    /// <param name="inputs">Further files that the frames depend on.</param>
    public static RunIdentity Of(
        string version, string arguments, LdemFingerprint model, string? engine, IReadOnlyList<InputFile> kernels,
        string? povRay, IReadOnlyList<InputFile> inputs)
    {
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            json.WriteString("version", version);
            json.WriteString("arguments", arguments);
            json.WriteStartObject("model");
            json.WriteString("product", model.ProductId);
            json.WriteNumber("bytes", model.ImageBytes);
            json.WriteString("sha256_of_parts", model.Sha256);
            json.WriteEndObject();
            json.WriteString("ephemeris", engine);
            json.WriteStartArray("kernels");
            foreach (InputFile kernel in kernels)
            {
                json.WriteStartObject();
                json.WriteString("name", kernel.Name);
                json.WriteString("sha256", kernel.Sha256);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteString("povray", povRay);
            if (inputs.Count > 0)
            {
                Write(json, inputs);
            }

            json.WriteEndObject();
        }

        return new RunIdentity(version, arguments, new SettingsRecord(KeyOf(stream.ToArray()), Encoding.UTF8.GetString(stream.ToArray())));
    }

    private static void Write(Utf8JsonWriter json, IReadOnlyList<InputFile> inputs)
    {
        json.WriteStartArray("inputs");
        foreach (InputFile input in inputs)
        {
            json.WriteStartObject();
            json.WriteString("kind", input.Kind.ToString());
            json.WriteString("name", input.Name);
            json.WriteString("sha256", input.Sha256);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <summary>The key of a content: the first half of its SHA-256 hash, hexadecimal.</summary>
    public static string KeyOf(ReadOnlySpan<byte> content) => Convert.ToHexStringLower(SHA256.HashData(content))[..KeyLength];
}
