using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Terrain;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.App.Series;

/// <summary>All that decides a run's frames but their states: equal identities and states make equal bytes, on any computer.</summary>
/// <param name="Version">Of the program.</param>
/// <param name="Arguments">See <see cref="FrameArguments.OfSettings"/>.</param>
/// <param name="Record">The same for the manifest, with checksums of the inputs.</param>
internal sealed record RunIdentity(string Version, string Arguments, SettingsRecord Record)
{
    /// <summary>Hexadecimal digits of a key: half of SHA-256.</summary>
    private const int KeyLength = 32;

    /// <summary>Collects it.</summary>
    /// <param name="version">Of the program.</param>
    /// <param name="arguments">See <see cref="FrameArguments.OfSettings"/>.</param>
    /// <param name="model">The elevation model.</param>
    /// <param name="engine">Name and version of the ephemeris engine; null if the Sun is ignored.</param>
    /// <param name="kernels">See <see cref="ChecksumsOf"/>.</param>
    /// <param name="povRay">Version of POV-Ray; null if it draws nothing.</param>
    public static RunIdentity Of(
        string version, string arguments, LdemFingerprint model, string? engine, IReadOnlyList<(string Name, string Sha256)> kernels,
        string? povRay)
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
            foreach ((string name, string hash) in kernels)
            {
                json.WriteStartObject();
                json.WriteString("name", name);
                json.WriteString("sha256", hash);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteString("povray", povRay);
            json.WriteEndObject();
        }

        return new RunIdentity(version, arguments, new SettingsRecord(KeyOf(stream.ToArray()), Encoding.UTF8.GetString(stream.ToArray())));
    }

    /// <summary>The key of some content.</summary>
    public static string KeyOf(ReadOnlySpan<byte> content) => Convert.ToHexStringLower(SHA256.HashData(content))[..KeyLength];

    /// <summary>Names and checksums of kernels; reads some 20 MB, so it is begun early.</summary>
    /// <param name="kernels">Their paths, in load order.</param>
    public static IReadOnlyList<(string Name, string Sha256)> ChecksumsOf(IReadOnlyList<string> kernels) => FileErrors.ToExternalPart(
        "a kernel can't be read",
        () => kernels.Select(path => (Path.GetFileName(path), FileHash.Sha256Of(path))).ToArray());
}
