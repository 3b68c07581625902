using System.Runtime.InteropServices;
using Msisf.Adapters.Interop;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Writes the layers of an image that is drawn row by row: all of them side by side, some rows at a time, so that the image is drawn once
/// and memory does not grow with its height. The bytes are those of layers that are written one after the other.
/// </summary>
internal static class FitsLayerBands
{
    /// <summary>Writes the layers as they are.</summary>
    /// <param name="stream">Receives them; can seek.</param>
    /// <param name="sampler">Computes them.</param>
    /// <param name="precision">Precision of their real numbers.</param>
    /// <param name="newImage">Makes the unit of a layer, as an image of a pixel.</param>
    /// <param name="cancellation">Stops between rows.</param>
    public static void Write(
        Stream stream, LayerSampler sampler, IReadOnlyList<Layer> layers, LayerPrecision precision,
        Func<Layer, FitsUnit> newImage, CancellationToken cancellation)
    {
        long end = stream.Position;
        Slot[] slots = new Slot[layers.Count];
        for (int index = 0; index < slots.Length; index++)
        {
            int headerLength = HeaderOf(layers[index], 0).Length;
            long rowLength = (long)sampler.Width * layers[index].StoredType(precision).Size();
            long length = rowLength * sampler.Height * layers[index].Planes;
            slots[index] = new Slot(end, end + headerLength, rowLength);
            end += headerLength + length + FitsUnit.FillOf(length);
        }

        stream.SetLength(end); // the zeros behind the data
        LayerPasses.RunInBands(sampler, layers, precision, LayerLayout.Fits, Write, cancellation);
        for (int index = 0; index < slots.Length; index++)
        {
            stream.Position = slots[index].Start;
            stream.Write(HeaderOf(layers[index], slots[index].Sum));
        }

        stream.Position = end;

        void Write(int firstRow, IReadOnlyList<StoredLayer> rows)
        {
            foreach ((Slot slot, StoredLayer layer) in slots.Zip(rows))
            {
                int length = layer.Bytes.Length / layer.Layer.Planes;
                for (int plane = 0; plane < layer.Layer.Planes; plane++)
                {
                    long offset = slot.RowLength * (((long)plane * sampler.Height) + firstRow);
                    ReadOnlySpan<byte> bytes = layer.Bytes.Slice(plane * length, length);
                    slot.Sum = FitsSum.Of(slot.Sum, FitsSum.Of(bytes, offset));
                    stream.Position = slot.DataStart + offset;
                    stream.Write(bytes);
                }
            }
        }

        byte[] HeaderOf(Layer layer, uint dataSum)
        {
            using FitsUnit image = newImage(layer);
            return image.HeaderOf(sampler.Width, sampler.Height, dataSum);
        }
    }

    /// <summary>Writes the layers compressed, by way of files beside the stream's, which go when they are done with.</summary>
    /// <param name="stream">Receives them.</param>
    /// <param name="sampler">Computes them.</param>
    /// <param name="precision">Precision of their real numbers.</param>
    /// <param name="newImage">Makes the unit of a layer in a file, without its pixels.</param>
    /// <param name="compressed">Compresses a unit into a file.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    public static void WriteCompressed(
        FileStream stream, LayerSampler sampler, IReadOnlyList<Layer> layers, LayerPrecision precision,
        Func<Layer, string, FitsUnit> newImage, Func<FitsUnit, Layer, string, FitsUnit> compressed, CancellationToken cancellation)
    {
        List<FitsUnit> images = [];
        try
        {
            foreach (Layer layer in layers)
            {
                images.Add(newImage(layer, $"{stream.Name}.{layer.Name}"));
            }

            LayerPasses.RunInBands(sampler, layers, precision, LayerLayout.ForCFitsio, Write, cancellation);
            foreach ((FitsUnit image, Layer layer) in images.Zip(layers))
            {
                cancellation.ThrowIfCancellationRequested();
                using FitsUnit small = compressed(image, layer, $"{stream.Name}.gzip");
                small.CopyTo(stream);
            }
        }
        finally
        {
            images.ForEach(image => image.Dispose());
        }

        void Write(int firstRow, IReadOnlyList<StoredLayer> rows)
        {
            foreach ((FitsUnit image, StoredLayer layer) in images.Zip(rows))
            {
                int length = layer.Bytes.Length / layer.Layer.Planes;
                for (int plane = 0; plane < layer.Layer.Planes; plane++)
                {
                    long first = sampler.Width * (((long)plane * sampler.Height) + firstRow);
                    Put(image, first, layer.Type, layer.Bytes.Slice(plane * length, length));
                }
            }
        }
    }

    /// <summary>Writes pixels of a unit.</summary>
    /// <param name="first">Where they begin in the image.</param>
    /// <param name="type">Type of the pixels.</param>
    /// <param name="bytes">The pixels, in memory order of the machine.</param>
    public static void Put(FitsUnit image, long first, LayerType type, ReadOnlySpan<byte> bytes)
    {
        switch (type)
        {
            case LayerType.Real64:
                image.Write(first, MemoryMarshal.Cast<byte, double>(bytes));
                break;
            case LayerType.Real32:
                image.Write(first, MemoryMarshal.Cast<byte, float>(bytes));
                break;
            case LayerType.Unsigned8:
                image.Write(first, bytes);
                break;
            default:
                image.Write(first, MemoryMarshal.Cast<byte, int>(bytes));
                break;
        }
    }

    /// <summary>Where a layer is in the file.</summary>
    /// <param name="start">Its header begins there.</param>
    /// <param name="rowLength">bytes.</param>
    private sealed class Slot(long start, long dataStart, long rowLength)
    {
        public long Start => start;

        public long DataStart => dataStart;

        public long RowLength => rowLength;

        /// <summary>The sum of the data so far.</summary>
        public uint Sum { get; set; }
    }
}
