using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization.Metadata;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>Reads the JSON of requests, and writes that of answers.</summary>
internal static class JsonBody
{
    /// <summary>bytes: a request with some thousand points.</summary>
    public const int LargestRequest = 1 << 20;

    /// <summary>Properties are in small letters with underscores. Apostrophes stay as they are: no answer is part of a page.</summary>
    public static readonly JsonSerializerOptions Names = new()
    {
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower,
        DictionaryKeyPolicy = JsonNamingPolicy.SnakeCaseLower,
        TypeInfoResolver = AnswerTypes.Default,
    };

    /// <summary>Reads the body of a request.</summary>
    /// <exception cref="RefusedException">It is said to be something else.</exception>
    /// <exception cref="JsonException">It is not JSON.</exception>
    public static async Task<JsonElement> ReadAsync(HttpRequest request)
    {
        if (!request.HasJsonContentType())
        {
            throw new RefusedException(
                StatusCodes.Status415UnsupportedMediaType, $"Content-Type is '{request.ContentType}'; {AnswerForm.Json} is needed.");
        }

        if (request.Headers.ContentEncoding is { Count: > 0 } encoding && encoding != "identity")
        {
            throw new RefusedException(
                StatusCodes.Status415UnsupportedMediaType, $"Content-Encoding is '{encoding}'; send the request without compression.");
        }

        using MemoryStream body = new();
        await request.Body.CopyToAsync(body, request.HttpContext.RequestAborted).ConfigureAwait(false);
        return JsonText.Parse(body.ToArray());
    }

    /// <summary>An object as JSON, its properties in small letters with underscores.</summary>
    /// <typeparam name="T">One of <see cref="AnswerTypes"/>.</typeparam>
    public static byte[] ToBytes<T>(T value) => JsonSerializer.SerializeToUtf8Bytes(value, (JsonTypeInfo<T>)Names.GetTypeInfo(typeof(T)));

    /// <summary>Sends an object as JSON.</summary>
    public static async Task SendAsync<T>(HttpResponse response, T value)
    {
        byte[] bytes = ToBytes(value);
        response.ContentType = AnswerForm.Json;
        response.ContentLength = bytes.Length;
        await response.Body.WriteAsync(bytes).ConfigureAwait(false);
    }
}
