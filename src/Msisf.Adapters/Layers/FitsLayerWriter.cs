using Msisf.Adapters.Interop;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Writes a frame's layers as one FITS file: a primary unit with the provenance, an image extension a layer (docs/formats.md).
/// </summary>
public static class FitsLayerWriter
{
    /// <summary>
    /// Rows of a compressed tile. With 16 rows of 1024 px the file is as small as with more (one row: 2 % larger), and a reader can still
    /// take a part of the image alone.
    /// </summary>
    private const int TileRows = 16;

    /// <summary>Checks that CFITSIO is installed, before frames are made.</summary>
    /// <exception cref="ExternalPartException">It can't be loaded.</exception>
    public static void RequireCFitsio() => CFitsio.RequireLibrary(CFitsioNative.Library);

    /// <summary>Writes one file. The bytes depend on the arguments alone, not on the clock or the number of cores.</summary>
    /// <param name="stream">Receives the file; stays open. An image that is drawn row by row has a file of its own for it.</param>
    /// <param name="frame">Goes into the primary header.</param>
    /// <param name="provenance">Goes there too.</param>
    /// <param name="truth">What the pixels show; its camera is the frame's.</param>
    /// <param name="precision">Precision of their real numbers.</param>
    /// <param name="compression">Compression of their data.</param>
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
        bool isCompressed = compression == LayerCompression.Gzip;
        if (sampler.RowsAtOnce < sampler.Height)
        {
            WriteInBands(stream, sampler, layers.Layers, precision, isCompressed, Describe, cancellation);
            WriteRowStates(stream, frame);
            return;
        }

        LayerPasses.Run(
            sampler,
            layers.Layers,
            precision,
            isCompressed ? LayerLayout.ForCFitsio : LayerLayout.Fits,
            layer =>
            {
                if (isCompressed)
                {
                    WriteCompressed(stream, sampler, layer, Describe);
                }
                else
                {
                    WriteLayer(stream, sampler, layer, Describe);
                }
            },
            cancellation);
        WriteRowStates(stream, frame);

        string Describe(Layer layer) => frame.Globe.Describe(layer.DescriptionOn(provenance.MeshResolution));
    }

    /// <summary>Writes the layers of an image that is drawn row by row.</summary>
    private static void WriteInBands(
        Stream stream, LayerSampler sampler, IReadOnlyList<Layer> layers, LayerPrecision precision, bool isCompressed,
        Func<Layer, string> describe, CancellationToken cancellation)
    {
        if (isCompressed)
        {
            FitsLayerBands.WriteCompressed(
                (FileStream)stream, sampler, layers, precision,
                (layer, path) => NewImage(layer, layer.StoredType(precision), sampler.Width, sampler.Height, describe(layer), path),
                (image, layer, path) => image.Compressed(path, TileRows, Lengths(layer, sampler.Width, sampler.Height)),
                cancellation);
            return;
        }

        FitsLayerBands.Write(
            stream, sampler, layers, precision,
            layer => NewImage(layer, layer.StoredType(precision), 1, 1, describe(layer)), cancellation);
    }

    private static void WriteLayer(Stream stream, LayerSampler sampler, StoredLayer layer, Func<Layer, string> describe)
    {
        using FitsUnit image = NewImage(layer.Layer, layer.Type, 1, 1, describe(layer.Layer));
        image.CopyTo(stream, sampler.Width, sampler.Height, layer.Bytes);
    }

    private static void WriteCompressed(Stream stream, LayerSampler sampler, StoredLayer layer, Func<Layer, string> describe)
    {
        using FitsUnit image = NewImage(layer.Layer, layer.Type, sampler.Width, sampler.Height, describe(layer.Layer));
        FitsLayerBands.Put(image, 0, layer.Type, layer.Bytes);
        using FitsUnit compressed = image.Compressed(path: null, TileRows, Lengths(layer.Layer, sampler.Width, sampler.Height));
        compressed.CopyTo(stream);
    }

    /// <summary>Writes the states of the rows of a scanned image; nothing for a frame.</summary>
    private static void WriteRowStates(Stream stream, FrameMetadata frame)
    {
        if (RowStates.Of(frame) is not { Length: > 0 } numbers)
        {
            return;
        }

        using FitsUnit image = FitsUnit.Image(path: null, BitsPerPixel(LayerType.Real64), RowStates.Names.Count, frame.Camera.Height);
        image.Put("EXTNAME", "ROWSTATES", "time and state of each row");
        for (int column = 0; column < RowStates.Names.Count; column++)
        {
            image.Put(Invariant($"COLUMN{column + 1}"), RowStates.Names[column], "what NAXIS1 counts");
        }

        foreach (string line in FitsText.Wrap(frame.Globe.Describe(
            "A row for each row of the image, the top one first: s after DATE-OBS, position (m, MOON_ME), the quaternion that turns camera "
                + "axes into MOON_ME, position of the light (m).")))
        {
            image.PutComment(line);
        }

        image.Write(0, numbers);
        image.CopyTo(stream);
    }

    private static ReadOnlySpan<long> Lengths(Layer layer, int width, int height) =>
        layer.Planes > 1 ? (long[])[width, height, layer.Planes] : (long[])[width, height];

    private static FitsUnit NewImage(Layer layer, LayerType type, int width, int height, string description, string? path = null)
    {
        FitsUnit image = FitsUnit.Image(path, BitsPerPixel(type), Lengths(layer, width, height));
        image.Put("EXTNAME", layer.ExtensionName, "layer");
        if (layer.Unit.Length > 0)
        {
            image.Put("BUNIT", layer.Unit, "unit of the values");
        }

        if (type == LayerType.Signed32)
        {
            image.Put("BLANK", Layer.UndefinedNumber, "pixels that show no surface");
        }

        for (int plane = 0; plane < layer.PlaneNames.Count; plane++)
        {
            image.Put(Invariant($"PLANE{plane + 1}"), layer.PlaneNames[plane], "what NAXIS3 counts");
        }

        image.Put("ROWORDER", "TOP-DOWN", "first row of the file is the image's top");
        foreach (string line in FitsText.Wrap(description))
        {
            image.PutComment(line);
        }

        return image;
    }

    private static int BitsPerPixel(LayerType type) => type switch
    {
        LayerType.Real64 => -64,
        LayerType.Real32 => -32,
        LayerType.Unsigned8 => 8,
        _ => 32,
    };
}

/// <summary>Compression of the layers in a FITS file.</summary>
public enum LayerCompression
{
    /// <summary>None: IMAGE extensions.</summary>
    None,

    /// <summary>Without loss, in tiles of whole rows, each by gzip after its bytes are sorted by significance (GZIP_2).</summary>
    Gzip,
}
