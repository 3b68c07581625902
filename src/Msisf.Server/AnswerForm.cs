using Microsoft.Extensions.Primitives;
using Microsoft.Net.Http.Headers;

namespace Msisf.Server;

/// <summary>The form in which a client accepts a frame.</summary>
/// <param name="Main">Content type of the answer.</param>
/// <param name="Image">Content type of the image in a multipart answer.</param>
/// <param name="Meta">Content type of the meta file in a multipart answer.</param>
internal sealed record AnswerForm(string Main, string Image, string Meta)
{
    public const string Png = "image/png";
    public const string Raw = "application/octet-stream";
    public const string Npy = "application/x-npy";
    public const string Fits = "application/fits";
    public const string Json = "application/json";
    public const string Xml = "application/xml";
    public const string Text = "text/plain";
    public const string Multipart = "multipart/mixed";

    private static readonly string[] Images = [Png, Raw, Npy];
    private static readonly string[] Metas = [Xml, Json];

    /// <summary>All forms of an answer, the default first.</summary>
    public static IReadOnlyList<string> All { get; } = [Png, Raw, Npy, Fits, Json, Xml, Multipart];

    /// <summary>Of a stream: the grey levels, and after them the layers that the frame names, both raw.</summary>
    public static AnswerForm LevelsAndLayers { get; } = new(Raw, Raw, Xml) { HasBoth = true };

    /// <summary>Whether a raw answer has the image and the layers.</summary>
    public bool HasBoth { get; private init; }

    /// <summary>Whether the answer has several parts.</summary>
    public bool IsMultipart => Main == Multipart;

    /// <summary>Reads the header Accept; without one the answer is a PNG.</summary>
    /// <exception cref="RefusedException">It names nothing that the server has.</exception>
    public static AnswerForm Of(StringValues accept)
    {
        if (accept.Count == 0)
        {
            return new AnswerForm(Png, Png, Xml);
        }

        string[] wanted = MediaTypeHeaderValue.TryParseList(accept, out IList<MediaTypeHeaderValue>? types)
            ? [.. types.OrderByDescending(type => type.Quality ?? 1.0).Where(type => type.Quality is not 0.0)
                .SelectMany(type => All.Where(form => new MediaTypeHeaderValue(form).IsSubsetOf(type)).Take(1))]
            : [];
        if (wanted.Length == 0)
        {
            throw new RefusedException(
                StatusCodes.Status406NotAcceptable, $"Accept is '{accept}'; the server has {string.Join(", ", All)}.");
        }

        string main = wanted.Contains(Multipart) ? Multipart : wanted[0];
        return new AnswerForm(main, wanted.FirstOrDefault(Images.Contains) ?? Png, wanted.FirstOrDefault(Metas.Contains) ?? Xml);
    }
}
