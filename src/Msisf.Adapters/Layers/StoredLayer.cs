using System.Buffers;
using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
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
    /// <param name="type">Of the stored numbers.</param>
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

    /// <summary>Of the stored numbers.</summary>
    public LayerType Type { get; }

    /// <summary>The numbers.</summary>
    public ReadOnlySpan<byte> Bytes => _bytes.AsSpan(0, _length);

    /// <summary>Puts in a row.</summary>
    /// <param name="row">From 0.</param>
    /// <param name="plane">Of the layer, from 0.</param>
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

    /// <summary>That of NumPy's arrays.</summary>
    public static LayerLayout Npy => new(IsInterleaved: true, IsBigEndian: !BitConverter.IsLittleEndian);
}
