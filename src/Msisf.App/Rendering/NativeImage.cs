using System.Buffers;
using System.Runtime.InteropServices;
using Msisf.Adapters.Render;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.Core.Camera;
using Msisf.Core.Certainty;
using Msisf.Core.Detector;
using Msisf.Core.Navigation;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Sensitivity;

namespace Msisf.App.Rendering;

/// <summary>A drawn frame in memory: its grey levels or the numbers of the detector, and its ground truth.</summary>
internal sealed class NativeImage(
    NativeDrawing drawing, NativeRenderer renderer, Frame frame, NativeFrame drawn, CameraDetector? detector, DetectorImage? detected,
    SkyOfFrame? sky = null)
    : IDisposable
{
    /// <summary>px: a thread's start takes as long as the levels of some thousand.</summary>
    private const int LeastOfAThread = 1 << 16;

    private readonly IGroundTruth _truth =
        detected is null ? drawn : new DetectedFrame(frame.Camera, drawn, detector?.Margin ?? 0, detected);

    private readonly GreyTable _grey = drawing.GreyOf(frame);

    /// <summary>What the camera's detector read out; null without a detector.</summary>
    public DetectorImage? Detected { get; } = detected;

    /// <summary>I/F of each pixel, by rows from the top.</summary>
    public ReadOnlySpan<double> RadianceFactors => _truth.RadianceFactors;

    /// <summary>Bytes of a pixel in <see cref="CopyLevels"/>: 1 or 2.</summary>
    public int BytesPerPixel => Detected is null ? drawing.Settings.BitDepth / 8 : sizeof(ushort);

    /// <summary>Bits of a grey level, or of a number of the detector.</summary>
    public int Bits => Detected is null ? drawing.Settings.BitDepth : drawing.Settings.Detector!.Settings.ConverterBits;

    /// <summary>What the grey levels mean; null for the numbers of a detector.</summary>
    public GreyTransfer? Transfer => Detected is null ? drawing.Settings.Grey.Transfer : null;

    /// <summary>Width of the image, px.</summary>
    public int Width => _truth.Camera.Width;

    /// <summary>Height of the image, px.</summary>
    public int Height => _truth.Camera.Height;

    /// <summary>What the image shows, also after it is disposed if it was drawn in memory of its own.</summary>
    public IGroundTruth Truth => _truth;

    public void WritePng(Stream png)
    {
        using PngImage image = BeginPng(png, Height);
        AddTo(image);
    }

    /// <summary>Begins a PNG of images like this one, one below the other.</summary>
    /// <param name="png">Receives it; stays open.</param>
    /// <param name="height">Height of all of them, px.</param>
    public PngImage BeginPng(Stream png, int height) => Detected is null
        ? new PngImage(png, Width, height, (byte)drawing.Settings.BitDepth, drawing.Settings.Grey.Transfer)
        : PngImage.OfNumbers(png, Width, height, drawing.Settings.Detector!.Settings.ConverterBits);

    public void AddTo(PngImage png)
    {
        if (Detected is { } detected)
        {
            png.Add(detected.Numbers);
            return;
        }

        int length = Width * Height * BytesPerPixel;
        byte[] memory = ArrayPool<byte>.Shared.Rent(length);
        Span<byte> levels = memory.AsSpan(0, length);
        CopyLevels(memory.AsMemory(0, length), threads: 1);
        if (BytesPerPixel == 1)
        {
            png.Add(levels);
        }
        else
        {
            png.Add(MemoryMarshal.Cast<byte, ushort>(levels));
        }

        ArrayPool<byte>.Shared.Return(memory);
    }

    /// <summary>Copies the grey levels, or the numbers of the detector, by rows from the top, in the byte order of this computer.</summary>
    /// <param name="levels">Receives them; <see cref="BytesPerPixel"/> for each pixel.</param>
    public void CopyLevels(Memory<byte> levels, int threads)
    {
        if (Detected is { } detected)
        {
            MemoryMarshal.AsBytes<ushort>(detected.Numbers).CopyTo(levels.Span);
            return;
        }

        ConvertGround(levels, threads);
        foreach ((int pixel, double factor) in sky?.Factors ?? [])
        {
            ConvertLevels([drawn.RadianceFactors[pixel] + factor], levels.Span.Slice(pixel * BytesPerPixel, BytesPerPixel));
        }
    }

    private void ConvertGround(Memory<byte> levels, int threads)
    {
        int parts = Width * Height / LeastOfAThread;
        if (parts < 2 || threads < 2)
        {
            ConvertLevels(drawn.RadianceFactors, levels.Span);
            return;
        }

        int length = (int)Math.Ceiling((double)(Width * Height) / parts);
        int next = -1;

        // A thread that ends other work joins in; with Parallel.For it does not.
        Task[] others = [.. Enumerable.Range(1, Math.Min(threads, parts) - 1).Select(_ => Task.Run(ConvertParts))];
        ConvertParts();
        Task.WaitAll(others);

        void ConvertParts()
        {
            for (int part = Interlocked.Increment(ref next); part < parts; part = Interlocked.Increment(ref next))
            {
                int start = part * length;
                int count = Math.Min(length, (Width * Height) - start);
                ConvertLevels(
                    drawn.RadianceFactors.Slice(start, count), levels.Span.Slice(start * BytesPerPixel, count * BytesPerPixel));
            }
        }
    }

    private void ConvertLevels(ReadOnlySpan<double> radianceFactors, Span<byte> levels)
    {
        if (BytesPerPixel == 1)
        {
            _grey.Convert(radianceFactors, levels);
        }
        else
        {
            _grey.Convert(radianceFactors, MemoryMarshal.Cast<byte, ushort>(levels));
        }
    }

    /// <summary>The frame as its files are written from it.</summary>
    /// <param name="image">The image as PNG.</param>
    public RenderedFrame ToRendered(Stream image, int threads = 1) => new(
        RendererKind.Native,
        image,
        "the image",
        WriteScene: null,
        renderer.Resolution,
        (renderer.Resolution, renderer.Resolution),
        drawing.Settings.Render.KeepGroundTruth ? _truth : null,
        Detected)
    {
        Redraw = Redraw,
        FindSensitivity = cancellation => FindSensitivity(threads, cancellation),
        FindCertain = (limits, cancellation) => new CertainPixels(renderer.Terrain, drawing.OptionsOf(frame), limits)
            .Find((FrameCamera)frame.Camera, frame.Light, threads, cancellation),
        Threads = threads,
        Terrain = renderer.Terrain,
        PartResolutions = renderer.PartResolutions,
        Sky = sky,
    };

    private FrameRedraw Redraw => new(renderer, drawn.Camera, detector?.Margin ?? 0, drawing.OptionsOf(frame));

    private ImageSensitivity FindSensitivity(int threads, CancellationToken cancellation)
    {
        SensitivityField factors = Redraw.Sensitivities(frame.Light, threads, cancellation);
        if (detector is null || Detected is null)
        {
            return new ImageSensitivity(factors, string.Empty, InformationOf: null);
        }

        SensitivityField electrons = detector.ElectronsOf(factors, drawn, threads, cancellation);
        return new ImageSensitivity(
            electrons, "electron", parameters => detector.InformationOf(electrons, parameters, Detected));
    }

    public void Dispose()
    {
        drawn.Dispose();
        if (Detected is { } detected)
        {
            detector?.GiveBack(detected);
        }

        drawing.Finished();
    }
}
