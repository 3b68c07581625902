using System.Diagnostics;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.App.Products;
using Msisf.App.Rendering;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Render.Photometry;

namespace Msisf.Server;

/// <summary>Draws a frame and writes the parts of its answer.</summary>
internal sealed class FrameAnswers(StreamPool pool)
{
    /// <summary>An answer that is kept in memory until it is sent.</summary>
    /// <param name="room">bytes: left free before the content of each part.</param>
    public Answer InMemory(int room = 0) => new(pool, room);

    /// <summary>An answer that is sent while it is made, if it is too long for memory.</summary>
    /// <param name="plan">What it will hold.</param>
    /// <param name="isMultipart">Whether it has several parts.</param>
    public Answer For(AnswerPlan plan, HttpResponse response, bool isMultipart) =>
        plan.IsSentAsMade ? new StreamedAnswer(pool, response, isMultipart) : InMemory();

    /// <param name="session">Draws it.</param>
    public static void Draw(
        Answer answer, RenderSession session, PreparedFrame frame, AnswerForm form, int threads, CancellationToken cancellation)
    {
        long start = Stopwatch.GetTimestamp();
        using NativeImage image = session.Draw(frame, threads, cancellation);
        answer.AddTime("draw", start);
        start = Stopwatch.GetTimestamp();
        answer.Stop = cancellation;
        Write(answer, session, frame, image, form, threads, cancellation);
        answer.AddTime("write", start);
    }

    /// <param name="form">Content type.</param>
    private static void AddImage(Answer answer, NativeImage image, string form, int threads)
    {
        switch (form)
        {
            case AnswerForm.Raw:
                string type = image.BytesPerPixel == 1 ? "u8" : "u16";
                answer.Add(
                    "image.raw", form, stream => CopyLevels(image, stream, threads),
                    [.. SizeOf(image.Width, image.Height, type), .. MeaningOf(image)]);
                break;
            case AnswerForm.Npy:
                answer.Add("image.npy", form, stream =>
                {
                    NpyFile.WriteImageHead(stream, image.BytesPerPixel, image.Height, image.Width);
                    CopyLevels(image, stream, threads);
                });
                break;
            default:
                answer.Add("image.png", form, image.WritePng);
                break;
        }
    }

    private static void Write(
        Answer answer, RenderSession session, PreparedFrame frame, NativeImage image, AnswerForm form, int threads,
        CancellationToken cancellation)
    {
        AnswerPlan plan = AnswerPlan.Of(form, session.Settings);
        if (plan is { HasImage: true, Products.Count: 0, Meta: { } both, IsSentAsMade: false } && threads > 1)
        {
            WriteBoth(answer, session, frame, image, form, both, threads, cancellation);
            return;
        }

        if (plan.HasImage)
        {
            AddImage(answer, image, form.IsMultipart ? form.Image : form.Main, threads);
        }

        if (plan is { Products.Count: 0, Meta: null })
        {
            return;
        }

        ProductFrame drawn = session.ToProducts(frame, image.ToRendered(Stream.Null, threads), cancellation);
        if (form.Main == AnswerForm.Fits)
        {
            NativeSettings fits = drawn.Settings.Native with { LayersFormat = LayerFormat.Fits };
            drawn = drawn with { Settings = drawn.Settings with { Native = fits } };
        }

        foreach (Product product in plan.Products)
        {
            if (plan.Layer is { } layer)
            {
                AddLayer(answer, drawn, layer, form);
                continue;
            }

            product.Write(drawn, (name, length, write) => answer.AddLarge(
                name, product.ContentType ?? AnswerForm.OfFile(name), length, write));
        }

        if (plan.Meta is { } meta)
        {
            answer.Add(NameOfMeta(meta), meta, stream => WriteMeta(stream, meta, drawn));
        }
    }

    /// <summary>Writes image and meta file side by side: a closed loop waits for both.</summary>
    private static void WriteBoth(
        Answer answer, RenderSession session, PreparedFrame frame, NativeImage image, AnswerForm form, string metaForm,
        int threads, CancellationToken cancellation)
    {
        Task<MemoryStream> meta = Task.Run(
            () => answer.Make(
                stream => WriteMeta(stream, metaForm, session.ToProducts(frame, image.ToRendered(Stream.Null), cancellation))),
            CancellationToken.None);
        try
        {
            AddImage(answer, image, form.Image, threads);
        }
        finally
        {
            Task.WaitAny([meta], CancellationToken.None); // it reads the image, which is gone after an exception
        }

        answer.Add(NameOfMeta(metaForm), metaForm, meta.GetAwaiter().GetResult());
    }

    private static string NameOfMeta(string form) => form == AnswerForm.Xml ? "xml" : "json";

    private static void WriteMeta(Stream stream, string form, ProductFrame frame)
    {
        if (form == AnswerForm.Xml)
        {
            MetadataXmlWriter.Write(stream, frame.Metadata, frame.Pixels, cancellation: frame.Cancellation);
            return;
        }

        MetadataJson.Write(stream, frame.Metadata, frame.Pixels, frame.Cancellation);
    }

    /// <summary>Adds a layer of its own, without the JSON file.</summary>
    private static void AddLayer(Answer answer, ProductFrame frame, Layer layer, AnswerForm form)
    {
        RenderSettings settings = frame.Settings;
        LayerPrecision precision = settings.Native.LayersPrecision;
        LayerSet layers = settings.Native.Layers!;
        (string Name, string Value)[] headers = form.Main != AnswerForm.Raw ? [] :
        [
            .. SizeOf(settings.Width, settings.Height, TypeOf(layer.StoredType(precision))),
            ("X-Msisf-Planes", layer.Planes.ToString(CultureInfo.InvariantCulture)),
        ];
        ArrayLayerWriter.Write(
            (name, length, write) =>
            {
                if (length is not null)
                {
                    answer.AddLarge(name, form.Main, length, write, headers);
                }
            },
            frame.Metadata, frame.Provenance, frame.TruthFor(layers), layers, precision,
            form.Main == AnswerForm.Raw ? ArrayFormat.Raw : ArrayFormat.Npy, frame.Cancellation);
    }

    private static string TypeOf(LayerType type) => type switch
    {
        LayerType.Real64 => "f64",
        LayerType.Real32 => "f32",
        LayerType.Unsigned8 => "u8",
        _ => "i32",
    };

    private static void CopyLevels(NativeImage image, MemoryStream stream, int threads)
    {
        int start = (int)stream.Length;
        int length = image.Width * image.Height * image.BytesPerPixel;
        stream.SetLength(start + length);
        image.CopyLevels(stream.GetBuffer().AsMemory(start, length), threads);
    }

    private static (string Name, string Value)[] SizeOf(int width, int height, string type) =>
    [
        ("X-Msisf-Width", width.ToString(CultureInfo.InvariantCulture)),
        ("X-Msisf-Height", height.ToString(CultureInfo.InvariantCulture)),
        ("X-Msisf-Type", type),
    ];

    private static (string Name, string Value)[] MeaningOf(NativeImage image) =>
    [
        ("X-Msisf-Bits", image.Bits.ToString(CultureInfo.InvariantCulture)),
        ("X-Msisf-Transfer", image.Transfer is { } transfer ? transfer == GreyTransfer.Srgb ? "srgb" : "linear" : "detector"),
    ];
}
