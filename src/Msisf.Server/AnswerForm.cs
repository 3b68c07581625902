using Microsoft.Extensions.Primitives;
using Microsoft.Net.Http.Headers;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Layers;

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
    public const string Tiff = "image/tiff";
    public const string Multipart = "multipart/mixed";

    private static readonly string[] Images = [Png, Raw, Npy];
    private static readonly string[] Metas = [Xml, Json];

    /// <summary>All forms of an answer, the default first.</summary>
    public static IReadOnlyList<string> All { get; } = [Png, Raw, Npy, Fits, Json, Xml, Multipart];

    /// <summary>Answer of a stream: the grey levels, and after them the layers that the frame names, both raw.</summary>
    public static AnswerForm LevelsAndLayers { get; } = new(Raw, Raw, Xml) { HasBoth = true };

    /// <summary>Whether a raw answer has the image and the layers.</summary>
    public bool HasBoth { get; private init; }

    /// <summary>Whether the answer has several parts.</summary>
    public bool IsMultipart => Main == Multipart;

    /// <summary>The content type of a file of a product.</summary>
    public static string OfFile(string name) => Path.GetExtension($".{name}") switch
    {
        ".npy" => Npy,
        ".fits" => Fits,
        ".json" => Json,
        ".tif" => Tiff,
        _ => Text,
    };

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

/// <summary>What an answer will hold, known before anything is drawn.</summary>
/// <param name="HasImage">Whether the image is in it.</param>
/// <param name="Products">What else of the frame, but the meta file.</param>
/// <param name="Meta">Content type of the meta file; null without.</param>
/// <param name="Bytes">Its length without compression.</param>
internal sealed record AnswerPlan(bool HasImage, IReadOnlyList<Product> Products, string? Meta, long Bytes)
{
    /// <summary>The only layer of an answer that holds it alone, or behind the image; null for others.</summary>
    public Layer? Layer { get; private init; }

    /// <summary>bytes: longer answers are sent while they are made.</summary>
    public const long LargestInMemory = 64L << 20;

    private const long BytesOfAMegabyte = 1_000_000;
    private const string LayersNeeded = "names no layer; name them in 'layers'.";

    /// <summary>Whether the answer is too long to be kept in memory.</summary>
    public bool IsSentAsMade => Bytes > LargestInMemory;

    public static AnswerPlan Of(AnswerForm form, RenderSettings settings)
    {
        NativeSettings native = settings.Native;
        bool isLayer = native.Layers is not null && form.Main is AnswerForm.Raw or AnswerForm.Npy;
        bool hasImage = (!isLayer || form.HasBoth)
            && (form.IsMultipart || form.Main is AnswerForm.Png or AnswerForm.Raw or AnswerForm.Npy);
        Product[] products = form.IsMultipart
            ? [.. ProductTable.Of(settings).Where(product => product.PlaceInAnswer is not null).OrderBy(product => product.PlaceInAnswer)]
            : isLayer || (form.Main == AnswerForm.Fits && native.Layers is not null) ? [ProductTable.Named("layers")]
            : form.Main == AnswerForm.Fits && native.Detector is not null ? [ProductTable.Named("numbers")]
            : [];
        string? meta = form.IsMultipart ? form.Meta : form.Main is AnswerForm.Xml or AnswerForm.Json ? form.Main : null;
        double bytesOfImage = hasImage ? native.Detector is null ? native.BitDepth / 8 : sizeof(ushort) : 0;
        double bytes = (bytesOfImage * settings.Width * settings.Height) + products.Sum(product => product.DiskBytes(settings));
        return new AnswerPlan(hasImage, products, meta, (long)bytes) { Layer = isLayer ? native.Layers!.Layers[0] : null };
    }

    /// <summary>The fields of a request that ask for a product.</summary>
    private static string NamesOf(Product product) =>
        string.Join(" or ", product.Files.SelectMany(file => file.Options).Select(option => $"'{option.Name.TrimStart('-')}'"));

    /// <summary>Refuses what can't be answered.</summary>
    /// <exception cref="RefusedException">The form does not fit the options, or the answer is too large.</exception>
    public void Check(AnswerForm form, RenderSettings settings, int maxMegabytes)
    {
        int layers = settings.Native.Layers?.Layers.Count ?? 0;
        string? problem = form.Main switch
        {
            _ when !form.IsMultipart && ProductTable.Of(settings).FirstOrDefault(
                product => product.PlaceInAnswer is not null && !product.CanBeAnswer) is { } part =>
                $"{NamesOf(part)} is for answers of several parts, and {form.Main} is one. Accept {AnswerForm.Multipart}.",
            AnswerForm.Fits when layers == 0 && settings.Native.Detector is null =>
                $"{form.Main} is for layers, and the request {LayersNeeded}",
            AnswerForm.Raw or AnswerForm.Npy when layers > 1 =>
                $"{form.Main} holds one layer, and the request names {layers}. Accept {AnswerForm.Multipart}.",
            _ => null,
        };
        if (problem is not null)
        {
            throw new RefusedException(StatusCodes.Status406NotAcceptable, problem);
        }

        if (Bytes > maxMegabytes * BytesOfAMegabyte)
        {
            string fewer = layers == 0 ? string.Empty : "fewer 'layers', 'layers-precision' single or ";
            throw new RefusedException(
                StatusCodes.Status413PayloadTooLarge,
                Invariant(
                    $"the answer has {Bytes / BytesOfAMegabyte} MB, more than the server's --max-megabytes of {maxMegabytes}. Ask for "
                        + $"{fewer}a smaller 'width' and 'height'."));
        }
    }
}
