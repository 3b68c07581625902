using System.Diagnostics;
using Msisf.Adapters.CameraExport;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.App.Rendering;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
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
        bool hasCameras = session.Settings.CameraFormats.Count > 0;
        if (plan is { HasImage: true, Layers: null, HasNumbers: false, Meta: { } both, IsSentAsMade: false } && threads > 1 && !hasCameras)
        {
            WriteBoth(answer, session, frame, image, form, both, threads, cancellation);
            return;
        }

        if (plan.HasImage)
        {
            AddImage(answer, image, form.IsMultipart ? form.Image : form.Main, threads);
        }

        if (plan is { Layers: null, HasNumbers: false, Meta: null })
        {
            return;
        }

        RenderedFrame rendered = image.ToRendered(Stream.Null);
        FrameMetadata metadata = session.Describe(frame, rendered);
        LayerProvenance provenance = session.Description.Provenance(metadata, rendered);
        if (plan.Layers is { } layers)
        {
            AddLayers(answer, session, plan, layers, form, new LayersOf(
                metadata, provenance, FrameNavigation.Mark(rendered.Truth!, metadata.Navigation, rendered.Sky, layers)), cancellation);
        }

        if (plan.HasNumbers)
        {
            answer.Add("dn.fits", AnswerForm.Fits, stream => DetectorFitsWriter.Write(
                stream, rendered.Numbers!, session.Settings.Native.Detector!.Settings, metadata, provenance));
        }

        if (hasCameras)
        {
            AddCameraModels(answer, session, frame, rendered, metadata, cancellation);
        }

        if (plan.Meta is { } meta)
        {
            answer.Add(NameOfMeta(meta), meta, stream => WriteMeta(stream, meta, session, frame, rendered, metadata, cancellation));
        }
    }

    /// <summary>Writes image and meta file side by side: a closed loop waits for both.</summary>
    private static void WriteBoth(
        Answer answer, RenderSession session, PreparedFrame frame, NativeImage image, AnswerForm form, string metaForm,
        int threads, CancellationToken cancellation)
    {
        Task<MemoryStream> meta = Task.Run(
            () => answer.Make(stream =>
            {
                RenderedFrame rendered = image.ToRendered(Stream.Null);
                WriteMeta(stream, metaForm, session, frame, rendered, session.Describe(frame, rendered), cancellation);
            }),
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

    /// <summary>Adds the files of msis, each as "csm.json", "tsai", ...</summary>
    private static void AddCameraModels(
        Answer answer, RenderSession session, PreparedFrame frame, RenderedFrame rendered, FrameMetadata metadata,
        CancellationToken cancellation)
    {
        using MemoryStream metaFile = new();
        WriteMeta(metaFile, AnswerForm.Xml, session, frame, rendered, metadata, cancellation);
        metaFile.Position = 0;
        ExportedFrame exported = CameraOfMetaFile.Read(
            metaFile, $"{frame.Frame.Name}.xml", frame.Frame, metadata, session.Settings) with
        {
            Ephemeris = session.Settings.CameraFormats.Any(format => format.NeedsEphemeris) ? session.Engine : null,
        };
        IReadOnlyList<CameraFormat> formats = session.Settings.CameraFormats;
        foreach ((string ending, Action<Stream> write) in CameraFormat.FilesOf(formats, exported, _ => { }, session.Log.Warning))
        {
            answer.Add(ending[1..], AnswerForm.Text, write);
        }
    }

    private static void AddLayers(
        Answer answer, RenderSession session, AnswerPlan plan, LayerSet layers, AnswerForm form, LayersOf of,
        CancellationToken cancellation)
    {
        NativeSettings native = session.Settings.Native;
        if (plan.IsFits)
        {
            answer.AddLarge("fits", AnswerForm.Fits, length: null, stream => FitsLayerWriter.Write(
                stream, of.Metadata, of.Provenance, of.Truth, layers, native.LayersPrecision, native.LayersCompression, cancellation));
            return;
        }

        NpyLayerWriter.Write(
            (name, length, write) => AddLayer(answer, session.Settings, layers, (name, length, write), form),
            of.Metadata, of.Provenance, of.Truth, layers, native.LayersPrecision, hasHeads: form.Main != AnswerForm.Raw, cancellation);
    }

    private static void WriteMeta(
        Stream stream, string form, RenderSession session, PreparedFrame frame, RenderedFrame rendered, FrameMetadata metadata,
        CancellationToken cancellation)
    {
        PixelSampler pixels = session.Description.Sampler(frame.Frame, rendered);
        if (form == AnswerForm.Xml)
        {
            MetadataXmlWriter.Write(stream, metadata, pixels, cancellation: cancellation);
            return;
        }

        MetadataJson.Write(stream, metadata, pixels, cancellation);
    }

    /// <summary>A layer of its own is sent without the JSON file.</summary>
    private static void AddLayer(
        Answer answer, RenderSettings settings, LayerSet layers, (string Name, long? Length, Action<Stream> Write) file, AnswerForm form)
    {
        if (file.Length is null)
        {
            if (form.IsMultipart)
            {
                answer.Add(file.Name, AnswerForm.Json, file.Write);
            }

            return;
        }

        Layer layer = layers.Layers[0];
        (string Name, string Value)[] headers = form.Main != AnswerForm.Raw ? [] :
        [
            .. SizeOf(settings.Width, settings.Height, TypeOf(layer.StoredType(settings.Native.LayersPrecision))),
            ("X-Msisf-Planes", layer.Planes.ToString(CultureInfo.InvariantCulture)),
        ];
        answer.AddLarge(file.Name, form.IsMultipart ? AnswerForm.Npy : form.Main, file.Length, file.Write, headers);
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

    /// <summary>What the files of layers are written from.</summary>
    private sealed record LayersOf(FrameMetadata Metadata, LayerProvenance Provenance, IGroundTruth Truth);
}
