using System.Buffers;
using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>The numbers of a layer as a file holds them. Rows may be put in from several threads.</summary>
internal sealed class StoredLayer : IDisposable
{
    /// <summary>Values that are converted at once where the planes are interleaved.</summary>
    private const int BlockLength = 256;

    private readonly LayerLayout _layout;
    private readonly int _width;
    private readonly int _height;
    private readonly int _length;
    private readonly byte[] _bytes;

    /// <summary>Takes memory.</summary>
    /// <param name="type">Type of the stored numbers.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    public StoredLayer(Layer layer, LayerType type, LayerLayout layout, int width, int height)
    {
        Layer = layer;
        Type = type;
        _layout = layout;
        _width = width;
        _height = height;
        _length = checked(width * height * layer.Planes * type.Size());
        _bytes = ArrayPool<byte>.Shared.Rent(_length);
    }

    public Layer Layer { get; }

    /// <summary>Type of the stored numbers.</summary>
    public LayerType Type { get; }

    /// <summary>The numbers.</summary>
    public ReadOnlySpan<byte> Bytes => _bytes.AsSpan(0, _length);

    /// <summary>Writes the rows into a file of an image with more of them.</summary>
    /// <param name="start">Where the numbers of the image begin.</param>
    /// <param name="first">Which row of the image the first one is, from 0.</param>
    /// <param name="height">Height of the image, px.</param>
    public void WriteRows(Stream file, long start, int first, int height)
    {
        int parts = _layout.IsInterleaved ? 1 : Layer.Planes;
        int length = _length / parts;
        long row = length / _height;
        for (int part = 0; part < parts; part++)
        {
            file.Position = start + (((part * (long)height) + first) * row);
            file.Write(Bytes.Slice(part * length, length));
        }
    }

    /// <summary>Puts in a row.</summary>
    /// <param name="row">From 0.</param>
    /// <param name="plane">Number of the layer, from 0.</param>
    /// <param name="values">As <see cref="LayerSampler.SampleRow"/> computes them.</param>
    public void Put(int row, int plane, ReadOnlySpan<double> values)
    {
        switch (Type)
        {
            case LayerType.Real64:
                Put<double>(row, plane, values, static (_, block, stored) => block.CopyTo(stored));
                break;
            case LayerType.Real32:
                Put<float>(row, plane, values, StoredValues.Round);
                break;
            case LayerType.Unsigned8:
                Put<byte>(row, plane, values, static (_, block, stored) => StoredValues.Convert(block, stored));
                break;
            default:
                Put<int>(row, plane, values, static (_, block, stored) => StoredValues.Convert(block, stored));
                break;
        }
    }

    /// <summary>Gives the memory back.</summary>
    public void Dispose() => ArrayPool<byte>.Shared.Return(_bytes);

    private void Put<T>(int row, int plane, ReadOnlySpan<double> values, Conversion<T> convert)
        where T : unmanaged
    {
        Span<T> stored = MemoryMarshal.Cast<byte, T>(_bytes.AsSpan());
        if (_layout.IsInterleaved && Layer.Planes > 1)
        {
            Interleave(stored[((row * _width * Layer.Planes) + plane)..], values, convert);
            return;
        }

        stored = stored.Slice(((plane * _height) + row) * _width, _width);
        convert(Layer, values, stored);
        if (_layout.IsBigEndian == BitConverter.IsLittleEndian)
        {
            Reverse(stored);
        }
    }

    private void Interleave<T>(Span<T> stored, ReadOnlySpan<double> values, Conversion<T> convert)
        where T : unmanaged
    {
        Span<T> block = stackalloc T[BlockLength];
        for (int first = 0; first < values.Length; first += BlockLength)
        {
            int count = Math.Min(BlockLength, values.Length - first);
            convert(Layer, values.Slice(first, count), block);
            for (int i = 0; i < count; i++)
            {
                stored[(first + i) * Layer.Planes] = block[i];
            }
        }
    }

    private static void Reverse<T>(Span<T> numbers)
        where T : unmanaged
    {
        if (Unsafe.SizeOf<T>() == sizeof(ulong))
        {
            Span<ulong> bits = MemoryMarshal.Cast<T, ulong>(numbers);
            BinaryPrimitives.ReverseEndianness(bits, bits);
        }
        else if (Unsafe.SizeOf<T>() == sizeof(uint))
        {
            Span<uint> bits = MemoryMarshal.Cast<T, uint>(numbers);
            BinaryPrimitives.ReverseEndianness(bits, bits);
        }
    }

    private delegate void Conversion<T>(Layer layer, ReadOnlySpan<double> values, Span<T> stored);
}

/// <summary>How the numbers of a layer follow each other in memory.</summary>
/// <param name="IsInterleaved">Whether the values of a pixel lie side by side; if not, the planes follow each other.</param>
/// <param name="IsBigEndian">Whether the most significant byte comes first; if not, the order is the machine's.</param>
internal readonly record struct LayerLayout(bool IsInterleaved, bool IsBigEndian)
{
    /// <summary>That of the data in a FITS file.</summary>
    public static LayerLayout Fits => new(IsInterleaved: false, IsBigEndian: true);

    /// <summary>That in which CFITSIO takes pixels.</summary>
    public static LayerLayout ForCFitsio => new(IsInterleaved: false, IsBigEndian: !BitConverter.IsLittleEndian);

    /// <summary>That of a page a plane in TIFF.</summary>
    public static LayerLayout Tiff => new(IsInterleaved: false, IsBigEndian: false);

    /// <summary>That of NumPy's arrays.</summary>
    public static LayerLayout Npy => new(IsInterleaved: true, IsBigEndian: !BitConverter.IsLittleEndian);
}

/// <summary>Turns computed values into the numbers that a file holds.</summary>
internal static class StoredValues
{
    /// <summary>Rounds values to single precision; NaN stays.</summary>
    /// <param name="layer">Directions that are rounded up to 360 degrees become 0.</param>
    /// <param name="values">Real numbers or NaN.</param>
    /// <param name="stored">As many.</param>
    public static void Round(Layer layer, ReadOnlySpan<double> values, Span<float> stored)
    {
        Narrow(values, stored);
        if (layer.IsDirection)
        {
            stored.Replace(360.0f, 0.0f);
        }
    }

    /// <summary>Converts values; what is undefined becomes <see cref="Layer.UndefinedNumber"/>.</summary>
    /// <typeparam name="T">byte (every value is defined) or int.</typeparam>
    /// <param name="values">Whole numbers or NaN.</param>
    /// <param name="stored">As many.</param>
    public static void Convert<T>(ReadOnlySpan<double> values, Span<T> stored)
        where T : unmanaged, INumberBase<T>
    {
        for (int i = 0; i < values.Length; i++)
        {
            stored[i] = double.IsNaN(values[i]) ? T.CreateChecked(Layer.UndefinedNumber) : T.CreateChecked(values[i]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // otherwise the first rows would be converted with unoptimised vectors
    private static void Narrow(ReadOnlySpan<double> values, Span<float> stored)
    {
        int i = 0;
        for (; i <= values.Length - Vector256<float>.Count; i += Vector256<float>.Count)
        {
            Vector256.Narrow(Vector256.Create(values[i..]), Vector256.Create(values[(i + Vector256<double>.Count)..])).CopyTo(stored[i..]);
        }

        for (; i < values.Length; i++)
        {
            stored[i] = (float)values[i];
        }
    }
}
