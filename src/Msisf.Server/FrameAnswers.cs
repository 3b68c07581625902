using System.Diagnostics;
using System.Globalization;
using Microsoft.AspNetCore.Http;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.App.Rendering;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;

namespace Msisf.Server;

/// <summary>Draws a frame and writes the parts of its answer.</summary>
internal sealed class FrameAnswers
{
    private const string LayersNeeded = "names no layer; name them in 'layers'.";

    private readonly StreamPool _pool;

    public FrameAnswers(StreamPool pool) => _pool = pool;

    /// <summary>Refuses what can't be answered, before anything is drawn.</summary>
    /// <param name="form">Form of the answer.</param>
    /// <param name="settings">Options of the frame.</param>
    /// <exception cref="RefusedException">The form does not fit the options.</exception>
    public static void Check(AnswerForm form, RenderSettings settings)
    {
        int layers = settings.Native.Layers?.Layers.Count ?? 0;
        string? problem = form.Main switch
        {
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
    }

    /// <summary>Draws a frame and writes its answer.</summary>
    /// <param name="session">Draws it.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="form">Form of the answer.</param>
    /// <param name="room">bytes: left free before the content of each part.</param>
    /// <param name="threads">Number of threads.</param>
    /// <param name="cancellation">Stops the work.</param>
    public Answer Draw(
        RenderSession session, PreparedFrame frame, AnswerForm form, int room, int threads, CancellationToken cancellation)
    {
        Answer answer = new(_pool, room);
        try
        {
            long start = Stopwatch.GetTimestamp();
            using NativeImage image = session.Draw(frame, threads, cancellation);
            answer.Times.Add(("draw", Stopwatch.GetElapsedTime(start).TotalMilliseconds));
            start = Stopwatch.GetTimestamp();
            Write(answer, session, frame, image, form, threads, cancellation);
            answer.Times.Add(("write", Stopwatch.GetElapsedTime(start).TotalMilliseconds));
            return answer;
        }
        catch
        {
            answer.Dispose();
            throw;
        }
    }

    /// <summary>Adds the image in a form.</summary>
    /// <param name="answer">Receives it.</param>
    /// <param name="image">The image.</param>
    /// <param name="form">Content type.</param>
    /// <param name="threads">Number of threads.</param>
    private static void AddImage(Answer answer, NativeImage image, string form, int threads)
    {
        switch (form)
        {
            case AnswerForm.Raw:
                string type = image.BytesPerPixel == 1 ? "u8" : "u16";
                answer.Add("image.raw", form, stream => CopyLevels(image, stream, threads), SizeOf(image, type));
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
        LayerSet? layers = session.Settings.Native.Layers;
        bool isLayer = layers is not null && form.Main is AnswerForm.Raw or AnswerForm.Npy;
        if (!isLayer && (form.IsMultipart || form.Main is AnswerForm.Png or AnswerForm.Raw or AnswerForm.Npy))
        {
            AddImage(answer, image, form.IsMultipart ? form.Image : form.Main, threads);
            if (!form.IsMultipart)
            {
                return;
            }
        }

        RenderedFrame rendered = image.ToRendered(Stream.Null);
        FrameMetadata metadata = session.Describe(frame, rendered);
        LayerProvenance provenance = session.Description.Provenance(metadata, rendered);
        bool isFits = form.IsMultipart ? session.Settings.Native.LayersFormat == LayersFormat.Fits : form.Main == AnswerForm.Fits;
        if (layers is not null && (form.IsMultipart || isLayer || isFits))
        {
            LayerPrecision precision = session.Settings.Native.LayersPrecision;
            if (isFits)
            {
                answer.Add("fits", AnswerForm.Fits, stream => FitsLayerWriter.Write(
                    stream, metadata, provenance, rendered.Truth!, layers, precision, session.Settings.Native.LayersCompression,
                    cancellation));
            }
            else
            {
                NpyLayerWriter.Write(
                    (name, write) => AddLayer(answer, image, layers, name, write, form), metadata, provenance, rendered.Truth!, layers,
                    precision, cancellation);
            }
        }

        if (image.Detected is { } detected && session.Settings.Native.Detector is { } detector
            && (form.IsMultipart ? detector.WritesFits : layers is null && isFits))
        {
            answer.Add("dn.fits", AnswerForm.Fits, stream =>
                DetectorFitsWriter.Write(stream, detected, detector.Settings, metadata, provenance));
        }

        string meta = form.IsMultipart ? form.Meta : form.Main;
        if (meta is AnswerForm.Xml or AnswerForm.Json)
        {
            answer.Add(
                meta == AnswerForm.Xml ? "xml" : "json",
                meta,
                stream => WriteMeta(stream, meta, session, frame, rendered, metadata, cancellation));
        }
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

        using MemoryStream xml = new();
        MetadataXmlWriter.Write(xml, metadata, pixels, LongEDigits.RoundTrip, cancellation);
        xml.Position = 0;
        MetadataJson.Write(stream, xml);
    }

    /// <summary>A layer of its own is sent without the JSON file; raw without the head of the array file.</summary>
    private static void AddLayer(
        Answer answer, NativeImage image, LayerSet layers, string name, Action<Stream> write, AnswerForm form)
    {
        bool isJson = name.EndsWith(".json", StringComparison.Ordinal);
        if (form.IsMultipart)
        {
            answer.Add(name, isJson ? AnswerForm.Json : AnswerForm.Npy, write);
        }
        else if (!isJson && form.Main == AnswerForm.Npy)
        {
            answer.Add(name, form.Main, write);
        }
        else if (!isJson)
        {
            Layer layer = layers.Layers[0];
            string type = layer.Type switch
            {
                LayerType.Real64 => "f64",
                LayerType.Unsigned8 => "u8",
                _ => "i32",
            };
            answer.Add(
                $"{layer.Name}.raw",
                form.Main,
                stream =>
                {
                    using MemoryStream npy = new();
                    write(npy);
                    stream.Write(npy.GetBuffer().AsSpan(0, (int)npy.Length)[NpyFile.LengthOfHead(npy.GetBuffer())..]);
                },
                [.. SizeOf(image, type), ("X-Msisf-Planes", layer.Planes.ToString(CultureInfo.InvariantCulture))]);
        }
    }

    private static void CopyLevels(NativeImage image, MemoryStream stream, int threads)
    {
        int start = (int)stream.Length;
        int length = image.Width * image.Height * image.BytesPerPixel;
        stream.SetLength(start + length);
        image.CopyLevels(stream.GetBuffer().AsMemory(start, length), threads);
    }

    private static (string Name, string Value)[] SizeOf(NativeImage image, string type) =>
    [
        ("X-Msisf-Width", image.Width.ToString(CultureInfo.InvariantCulture)),
        ("X-Msisf-Height", image.Height.ToString(CultureInfo.InvariantCulture)),
        ("X-Msisf-Type", type),
    ];
}
