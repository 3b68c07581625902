using System.Runtime.InteropServices;
using Msisf.Adapters.IO;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Writes a frame's layers as array files of NumPy, one a layer, and their provenance as JSON (docs/formats.md). Needs no library.
/// </summary>
public static class NpyLayerWriter
{
    /// <summary>Writes the files; they appear when the set is committed. The bytes depend on the arguments alone.</summary>
    /// <param name="files">Takes the files.</param>
    /// <param name="stem">Path that the files' names begin with: "stem.layer.npy" and "stem.layers.json".</param>
    /// <param name="frame">Goes into the JSON file.</param>
    /// <param name="provenance">Goes there too.</param>
    /// <param name="truth">What the pixels show; its camera is the frame's.</param>
    /// <param name="precision">Of their real numbers.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <returns>The paths, the JSON file last.</returns>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static IReadOnlyList<string> Write(
        AtomicFileSet files,
        string stem,
        FrameMetadata frame,
        LayerProvenance provenance,
        IGroundTruth truth,
        LayerSet layers,
        LayerPrecision precision = LayerPrecision.Real64,
        CancellationToken cancellation = default)
    {
        List<string> paths = [];
        LayerSampler sampler = new(truth, provenance);
        if (sampler.RowsAtOnce < sampler.Height)
        {
            WriteInBands([]);
            WriteOthers(Put, frame, provenance, layers, hasHeads: true);
        }
        else
        {
            Write(Put, frame, provenance, truth, layers, precision, hasHeads: true, cancellation);
        }

        return paths;

        void Put(string name, long? length, Action<Stream> write)
        {
            paths.Add($"{stem}.{name}");
            files.Write(paths[^1], write);
        }

        // All files are open at once: each opens the next one, and the last one draws the rows.
        void WriteInBands(Stream[] streams)
        {
            if (streams.Length == layers.Layers.Count)
            {
                LayerPasses.RunInBands(
                    sampler, layers.Layers, precision, LayerLayout.Npy,
                    (_, rows) =>
                    {
                        foreach ((Stream stream, StoredLayer layer) in streams.Zip(rows))
                        {
                            stream.Write(layer.Bytes);
                        }
                    },
                    cancellation);
                return;
            }

            Layer layer = layers.Layers[streams.Length];
            Put($"{layer.Name}.npy", null, stream =>
            {
                stream.Write(HeadOf(sampler, layer, layer.StoredType(precision)));
                WriteInBands([.. streams, stream]);
            });
        }
    }

    /// <summary>Writes the same to other streams.</summary>
    /// <param name="put">
    /// Receives the name of a file without its stem, "layer.npy" or "layers.json", its length in bytes (null of the JSON file) and what
    /// writes it.
    /// </param>
    /// <param name="frame">Goes into the JSON file.</param>
    /// <param name="provenance">Goes there too.</param>
    /// <param name="truth">What the pixels show; its camera is the frame's.</param>
    /// <param name="precision">Of their real numbers.</param>
    /// <param name="hasHeads">Whether the array files have heads; without, they are "layer.raw" and hold nothing but the numbers.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Write(
        Action<string, long?, Action<Stream>> put, FrameMetadata frame, LayerProvenance provenance, IGroundTruth truth, LayerSet layers,
        LayerPrecision precision, bool hasHeads, CancellationToken cancellation)
    {
        LayerSampler sampler = new(truth, provenance);
        LayerPasses.Run(
            sampler,
            layers.Layers,
            precision,
            LayerLayout.Npy,
            layer =>
            {
                byte[] head = hasHeads ? HeadOf(sampler, layer.Layer, layer.Type) : [];
                put($"{layer.Layer.Name}.{(hasHeads ? "npy" : "raw")}", head.Length + (long)layer.Bytes.Length, stream =>
                {
                    stream.Write(head);
                    stream.Write(layer.Bytes);
                });
            },
            cancellation);
        WriteOthers(put, frame, provenance, layers, hasHeads);
    }

    /// <summary>Writes the states of a scanned image's rows, and the JSON file.</summary>
    private static void WriteOthers(
        Action<string, long?, Action<Stream>> put, FrameMetadata frame, LayerProvenance provenance, LayerSet layers, bool hasHeads)
    {
        if (RowStates.Of(frame) is { Length: > 0 } rows)
        {
            WriteRowStates(put, rows, frame.Camera.Height, hasHeads);
        }

        put("layers.json", null, stream => LayersJson.Write(stream, frame, provenance, layers));
    }

    /// <summary>Writes the states of the rows of a scanned image.</summary>
    private static void WriteRowStates(Action<string, long?, Action<Stream>> put, double[] rows, int height, bool hasHeads)
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

    private static byte[] HeadOf(LayerSampler sampler, Layer layer, LayerType type)
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
