using System.Runtime.InteropServices;
using Msisf.Adapters.IO;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Writes a frame's layers as files of arrays, one a layer, and their provenance as JSON (docs/formats.md). Needs no library.
/// </summary>
public static class ArrayLayerWriter
{
    /// <summary>Writes the files. The bytes depend on the arguments alone.</summary>
    /// <param name="put">Receives "layer.npy" of each layer, and at last "layers.json".</param>
    /// <param name="frame">Goes into the JSON file.</param>
    /// <param name="provenance">Goes there too.</param>
    /// <param name="truth">What the pixels show; its camera is the frame's.</param>
    /// <param name="precision">Precision of their real numbers.</param>
    /// <param name="format">Format of the arrays.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Write(
        PutFile put, FrameMetadata frame, LayerProvenance provenance, IGroundTruth truth, LayerSet layers,
        LayerPrecision precision = LayerPrecision.Real64, ArrayFormat format = ArrayFormat.Npy, CancellationToken cancellation = default)
    {
        LayerSampler sampler = new(truth, provenance);
        LayerLayout layout = format == ArrayFormat.Tiff ? LayerLayout.Tiff : LayerLayout.Npy;
        if (sampler.RowsAtOnce < sampler.Height)
        {
            WriteInBands([]);
        }
        else
        {
            LayerPasses.Run(sampler, layers.Layers, precision, layout, WriteLayer, cancellation);
        }

        if (RowStates.Of(frame) is { Length: > 0 } rows)
        {
            WriteRowStates(put, rows, frame.Camera.Height, format != ArrayFormat.Raw);
        }

        put("layers.json", null, stream => LayersJson.Write(stream, frame, provenance, layers));

        string NameOf(Layer layer) => $"{layer.Name}.{format switch
        {
            ArrayFormat.Npy => "npy",
            ArrayFormat.Tiff => "tif",
            _ => "raw",
        }}";

        byte[] HeadOf(Layer layer, LayerType type) => format switch
        {
            ArrayFormat.Npy => NpyHead(sampler, layer, type),
            ArrayFormat.Tiff => TiffHead.Of(
                layer, type, sampler.Width, sampler.Height, frame.Version,
                frame.Globe.Describe(layer.DescriptionOn(provenance.MeshResolution))),
            _ => [],
        };

        void WriteLayer(StoredLayer layer)
        {
            byte[] head = HeadOf(layer.Layer, layer.Type);
            put(NameOf(layer.Layer), head.Length + (long)layer.Bytes.Length, stream =>
            {
                stream.Write(head);
                stream.Write(layer.Bytes);
            });
        }

        // All files are open at once: each opens the next one, and the last one draws the rows.
        void WriteInBands((Stream Stream, long Start)[] files)
        {
            if (files.Length == layers.Layers.Count)
            {
                LayerPasses.RunInBands(
                    sampler, layers.Layers, precision, layout,
                    (first, rows) =>
                    {
                        foreach (((Stream stream, long start), StoredLayer layer) in files.Zip(rows))
                        {
                            layer.WriteRows(stream, start, first, sampler.Height);
                        }
                    },
                    cancellation);
                return;
            }

            Layer layer = layers.Layers[files.Length];
            put(NameOf(layer), null, stream =>
            {
                stream.Write(HeadOf(layer, layer.StoredType(precision)));
                WriteInBands([.. files, (stream, stream.Position)]);
            });
        }
    }

    /// <summary>Writes the states of the rows of a scanned image.</summary>
    private static void WriteRowStates(PutFile put, double[] rows, int height, bool hasHeads)
    {
        using MemoryStream head = new();
        if (hasHeads)
        {
            NpyFile.WriteHead(head, LayerType.Real64, height, RowStates.Names.Count);
        }

        put($"rowstates.{(hasHeads ? "npy" : "raw")}", head.Length + (sizeof(double) * (long)rows.Length), stream =>
        {
            stream.Write(head.ToArray());
            stream.Write(MemoryMarshal.AsBytes<double>(rows));
        });
    }

    private static byte[] NpyHead(LayerSampler sampler, Layer layer, LayerType type)
    {
        using MemoryStream stream = new();
        if (layer.Planes > 1)
        {
            NpyFile.WriteHead(stream, type, sampler.Height, sampler.Width, layer.Planes);
        }
        else
        {
            NpyFile.WriteHead(stream, type, sampler.Height, sampler.Width);
        }

        return stream.ToArray();
    }
}

/// <summary>A file format of arrays.</summary>
public enum ArrayFormat
{
    /// <summary>That of NumPy.</summary>
    Npy,

    /// <summary>TIFF: a page a plane.</summary>
    Tiff,

    /// <summary>Nothing but the numbers, as NumPy's files have them.</summary>
    Raw,
}
