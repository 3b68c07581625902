using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Samples in a file, of the machine's byte order or reversed; the addresses need not be aligned.</summary>
internal unsafe interface ISampleFormat
{
    static abstract float One(byte* samples, int index, bool isReversed);

    /// <summary>Eight samples from an index on; needs AVX2.</summary>
    static abstract Vector256<float> Eight(byte* samples, int index, bool isReversed);
}

/// <summary>16-bit integers.</summary>
internal readonly unsafe struct Int16Samples : ISampleFormat
{
    public static float One(byte* samples, int index, bool isReversed) => Value(samples, index, isReversed);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Eight(byte* samples, int index, bool isReversed) =>
        Avx.ConvertToVector256Single(Avx2.ConvertToVector256Int32(Values(samples, index, isReversed)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<short> Values(byte* samples, int index, bool isReversed)
    {
        Vector128<short> values = Vector128.Load((short*)samples + index);
        return isReversed ? Vector128.ShiftLeft(values, 8) | Vector128.ShiftRightLogical(values, 8) : values;
    }

    private static short Value(byte* samples, int index, bool isReversed)
    {
        short value = Unsafe.ReadUnaligned<short>((short*)samples + index);
        return isReversed ? BinaryPrimitives.ReverseEndianness(value) : value;
    }
}

/// <summary>32-bit floats.</summary>
internal readonly unsafe struct Float32Samples : ISampleFormat
{
    public static float One(byte* samples, int index, bool isReversed)
    {
        uint bits = Unsafe.ReadUnaligned<uint>((uint*)samples + index);
        return BitConverter.UInt32BitsToSingle(isReversed ? BinaryPrimitives.ReverseEndianness(bits) : bits);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Eight(byte* samples, int index, bool isReversed)
    {
        Vector256<float> values = Vector256.Load((float*)samples + index);
        return isReversed
            ? Vector256.Shuffle(
                values.AsByte(),
                Vector256.Create(
                    (byte)3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12, 19, 18, 17, 16, 23, 22, 21, 20, 27, 26, 25, 24, 31, 30, 29,
                    28)).AsSingle()
            : values;
    }
}
