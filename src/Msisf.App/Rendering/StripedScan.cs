using Msisf.Adapters.Layers;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>
/// Draws scanned images that are too large for the memory, strip by strip: the PNG and the numbers of a detector are written as they are
/// drawn, and rows are drawn again where the meta file or layers ask for their ground truth.
/// </summary>
/// <param name="files">Writes the files.</param>
internal sealed class StripedScan(NativeDrawing drawing, FrameFiles files, RunTimes times)
{
    /// <summary>Draws an image and writes its files.</summary>
    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    /// <param name="cancellation">Stops the work; no file is left.</param>
    /// <returns>The paths of the files.</returns>
    public IReadOnlyList<string> Write(Frame frame, int threads, CancellationToken cancellation)
    {
        NativeRenderer renderer = drawing.RendererOf(frame);
        int height = frame.Camera.Height;
        int rows = RowsOfStrip(frame);
        using FileStream image = files.OpenTemporary();
        using FileStream? read = drawing.Settings.Detector is { WritesFits: true } ? files.OpenTemporary() : null;
        PngImage? png = null;
        DetectorNumbers? numbers = null;
        try
        {
            for (int first = 0; first < height; first += rows)
            {
                PixelRows strip = new(first, Math.Min(height, first + rows));
                using NativeImage drawn = drawing.DrawRows(frame, renderer, strip, keepsTruth: false, threads, cancellation);
                png ??= drawn.BeginPng(image, height);
                PngImage begun = png;
                times.Measure(Phase.Output, () => drawn.AddTo(begun));
                if (read is not null)
                {
                    numbers ??= new DetectorNumbers(read, frame.Camera.Width, height, drawn.Detected!.Noise);
                    numbers.Add(drawn.Detected!.Numbers);
                }
            }
        }
        finally
        {
            png?.Dispose();
        }

        image.Position = 0;
        StripedTruth truth = new(
            frame.Camera, frame.Light, rows, RowsOfExposure(frame),
            wanted => drawing.DrawRows(frame, renderer, wanted, keepsTruth: true, threads, cancellation).Truth);
        return files.Write(
            frame,
            new RenderedFrame(
                RendererKind.Native, image, "the image", WriteScene: null, renderer.Resolution, (renderer.Resolution, renderer.Resolution),
                drawing.Settings.Render.KeepGroundTruth ? truth : null)
            {
                Threads = threads,
                Numbers = numbers,
                Terrain = renderer.Terrain,
                PartResolutions = renderer.PartResolutions,
            },
            cancellation);
    }

    /// <summary>Rows of a strip: of whole exposures.</summary>
    private static int RowsOfStrip(Frame frame)
    {
        long pixelsOfExposure = (long)frame.Camera.Width * RowsOfExposure(frame);
        return (int)Math.Max(1, StripRules.PixelsOfStrip / pixelsOfExposure) * RowsOfExposure(frame);
    }

    private static int RowsOfExposure(Frame frame) => frame.Camera.Height / frame.Scan!.Count;
}
