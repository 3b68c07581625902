using System.Globalization;
using Msisf.Adapters.Interop;
using Msisf.Core.Errors;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Writes a frame's layers as one FITS file: a primary unit with the provenance, an image extension a layer (docs/formats.md).
/// </summary>
public static class FitsLayerWriter
{
    private delegate void Conversion<T>(ReadOnlySpan<double> values, Span<T> stored);

    /// <summary>Pixels that are converted at once, so that they stay in the processor's cache.</summary>
    private const int BlockPixels = 16384;

    /// <summary>
    /// Rows of a compressed tile. With 16 rows of 1024 px the file is as small as with more (one row: 2 % larger), and a reader can still
    /// take a part of the image alone.
    /// </summary>
    private const int TileRows = 16;

    /// <summary>Checks that CFITSIO is installed, before frames are made.</summary>
    /// <exception cref="ExternalPartException">It can't be loaded.</exception>
    public static void RequireCFitsio() => CFitsio.RequireLibrary(CFitsioNative.Library);

    /// <summary>Writes one file. The bytes depend on the arguments alone, not on the clock or the number of cores.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="frame">Goes into the primary header.</param>
    /// <param name="provenance">Goes there too.</param>
    /// <param name="truth">What the pixels show; its camera is the frame's.</param>
    /// <param name="layers">Which.</param>
    /// <param name="precision">Of their real numbers.</param>
    /// <param name="compression">Of their data.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <exception cref="ExternalPartException">CFITSIO is missing or fails.</exception>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Write(
        Stream stream, FrameMetadata frame, LayerProvenance provenance, IGroundTruth truth, LayerSet layers,
        LayerPrecision precision = LayerPrecision.Real64, LayerCompression compression = LayerCompression.None,
        CancellationToken cancellation = default)
    {
        using (FitsUnit primary = FitsUnit.Primary())
        {
            FitsProvenance.Put(primary, frame, provenance);
            primary.CopyTo(stream);
        }

        LayerSampler sampler = new(truth, provenance);
        LayerPasses.Run(
            sampler,
            layers.Layers,
            (layer, planes) => WriteLayer(stream, sampler, layer, frame.Globe, layer.StoredType(precision), compression, planes),
            cancellation);
    }

    private static void WriteLayer(
        Stream stream, LayerSampler sampler, Layer layer, DrawnGlobe globe, LayerType type, LayerCompression compression,
        IReadOnlyList<double[]> planes)
    {
        ReadOnlySpan<long> lengths = layer.Planes > 1 ? [sampler.Width, sampler.Height, layer.Planes] : [sampler.Width, sampler.Height];
        using FitsUnit image = FitsUnit.Image(BitsPerPixel(type), lengths);
        PutHeader(image, layer, globe);
        int pixels = sampler.Width * sampler.Height;
        for (int plane = 0; plane < planes.Count; plane++)
        {
            WritePlane(image, layer, type, plane * (long)pixels, planes[plane].AsSpan(0, pixels));
        }

        if (compression == LayerCompression.None)
        {
            image.CopyTo(stream);
            return;
        }

        using FitsUnit compressed = image.Compressed(TileRows, lengths);
        compressed.CopyTo(stream);
    }

    private static void PutHeader(FitsUnit image, Layer layer, DrawnGlobe globe)
    {
        image.Put("EXTNAME", layer.ExtensionName, "layer");
        if (layer.Unit.Length > 0)
        {
            image.Put("BUNIT", layer.Unit, "unit of the values");
        }

        if (layer.Type == LayerType.Signed32)
        {
            image.Put("BLANK", Layer.UndefinedNumber, "pixels that show no surface");
        }

        for (int plane = 0; plane < layer.PlaneNames.Count; plane++)
        {
            image.Put(string.Create(CultureInfo.InvariantCulture, $"PLANE{plane + 1}"), layer.PlaneNames[plane], "what NAXIS3 counts");
        }

        image.Put("ROWORDER", "TOP-DOWN", "first row of the file is the image's top");
        foreach (string line in FitsText.Wrap(globe.Describe(layer.Description)))
        {
            image.PutComment(line);
        }
    }

    private static void WritePlane(FitsUnit image, Layer layer, LayerType type, long first, ReadOnlySpan<double> values)
    {
        switch (type)
        {
            case LayerType.Real64:
                image.Write(first, values);
                break;
            case LayerType.Real32:
                WriteConverted<float>(image, first, values, (block, stored) => StoredValues.Round(layer, block, stored));
                break;
            case LayerType.Unsigned8:
                WriteConverted<byte>(image, first, values, StoredValues.Convert);
                break;
            default:
                WriteConverted<int>(image, first, values, StoredValues.Convert);
                break;
        }
    }

    private static void WriteConverted<T>(FitsUnit image, long first, ReadOnlySpan<double> values, Conversion<T> convert)
        where T : unmanaged
    {
        T[] block = new T[Math.Min(BlockPixels, values.Length)];
        for (int done = 0; done < values.Length; done += block.Length)
        {
            int count = Math.Min(block.Length, values.Length - done);
            convert(values.Slice(done, count), block.AsSpan(0, count));
            image.Write<T>(first + done, block.AsSpan(0, count));
        }
    }

    private static int BitsPerPixel(LayerType type) => type switch
    {
        LayerType.Real64 => -64,
        LayerType.Real32 => -32,
        LayerType.Unsigned8 => 8,
        _ => 32,
    };
}
