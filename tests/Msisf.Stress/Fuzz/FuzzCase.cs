using System.IO.Compression;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace Msisf.Stress.Fuzz;

/// <summary>A call of the program with damaged input.</summary>
/// <param name="Folder">The case's own; all that the call may write lies below it.</param>
/// <param name="Arguments">As <c>main</c> gets them.</param>
/// <param name="StandardInput">What stands there.</param>
/// <param name="DamagedFile">The file that was damaged; null if only the arguments or standard input were.</param>
internal sealed record FuzzCase(string Folder, IReadOnlyList<string> Arguments, string StandardInput = "", string? DamagedFile = null)
{
    private static readonly JsonSerializerOptions Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>Characters: up to here content is told as text.</summary>
    private const int LongestText = 4000;

    /// <summary>The whole input, on one line; the damaged file as text, or compressed by gzip and then in Base64.</summary>
    /// <param name="number">Of the case.</param>
    public string Describe(int number)
    {
        StringBuilder text = new(FormattableString.Invariant($"case {number}: msis {string.Join(' ', Arguments.Select(Json))}"));
        if (StandardInput.Length > 0)
        {
            text.Append(" standard input ").Append(Json(StandardInput));
        }

        if (DamagedFile is not null)
        {
            byte[] content = File.Exists(DamagedFile) ? File.ReadAllBytes(DamagedFile) : [];
            bool isText = content.Length <= LongestText
                && content.All(value => value is >= 0x20 and < 0x7F or (byte)'\n' or (byte)'\r' or (byte)'\t');
            text.Append(" with ").Append(Path.GetFileName(DamagedFile)).Append(' ').Append(
                isText ? Json(Encoding.ASCII.GetString(content)) : $"gzip:{Compressed(content)}");
        }

        return text.Replace(Folder, "FOLDER").ToString();
    }

    private static string Json(string text) => JsonSerializer.Serialize(text, Plain);

    private static string Compressed(byte[] content)
    {
        using MemoryStream stream = new();
        using (GZipStream gzip = new(stream, CompressionLevel.SmallestSize))
        {
            gzip.Write(content);
        }

        return Convert.ToBase64String(stream.ToArray());
    }
}
