using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Reads the sample values of one kind of elevation model; the addresses need not be aligned. Safe for several threads.</summary>
internal abstract unsafe class SampleCodec
{
    protected SampleCodec(LdemLabel label) =>
        (Lowest, Highest) = (MinFrom(label.Minimum - label.Slack), -MinFrom(-(label.Maximum + label.Slack)));

    /// <summary>No value is below.</summary>
    protected float Lowest { get; }

    /// <summary>No value is above.</summary>
    protected float Highest { get; }

    /// <summary>The codec for a label's samples.</summary>
    public static SampleCodec For(LdemLabel label) => label.SampleType switch
    {
        LdemSampleType.Int16LittleEndian or LdemSampleType.Int16BigEndian => new SampleCodec<Int16Samples>(label),
        _ => new SampleCodec<Float32Samples>(label),
    };

    /// <summary>Whether the label allows a value.</summary>
    public bool IsAllowed(double value) => value >= Lowest && value <= Highest;

    /// <summary>The value of one sample.</summary>
    public abstract double ValueAt(byte* sample);

    /// <summary>offset + scale * value for consecutive samples.</summary>
    /// <returns>False if a value is not allowed.</returns>
    public abstract bool TryReadRadii(byte* samples, Span<double> radii);

    /// <summary>The smallest float that is not below a number: floats can be compared with it instead.</summary>
    private static float MinFrom(double limit) => (float)limit < limit ? MathF.BitIncrement((float)limit) : (float)limit;
}

/// <summary>The codec of a format, eight samples at a time; 16-bit integers are floats exactly.</summary>
internal sealed unsafe class SampleCodec<TFormat> : SampleCodec
    where TFormat : struct, ISampleFormat
{
    private readonly bool _isReversed;
    private readonly double _scale;
    private readonly double _offset;

    public SampleCodec(LdemLabel label)
        : base(label)
    {
        _isReversed = label.SampleType is LdemSampleType.Int16BigEndian or LdemSampleType.Float32BigEndian == BitConverter.IsLittleEndian;
        (_scale, _offset) = (label.ScalingFactor, label.Offset);
    }

    public override double ValueAt(byte* sample) => TFormat.One(sample, 0, _isReversed);

    public override bool TryReadRadii(byte* samples, Span<double> radii)
    {
        if (Avx2.IsSupported && radii.Length >= Vector256<float>.Count)
        {
            return TryReadEights(samples, radii);
        }

        bool areAllowed = true;
        for (int i = 0; i < radii.Length; i++)
        {
            double value = TFormat.One(samples, i, _isReversed);
            areAllowed &= IsAllowed(value);
            radii[i] = _offset + (_scale * value);
        }

        return areAllowed;
    }

    /// <summary>
    /// Eight at a time; the last eight may overlap those before, which is cheaper than up to seven single ones. No fused
    /// multiplication: the radii have the same bits on each machine.
    /// </summary>
    private bool TryReadEights(byte* samples, Span<double> radii)
    {
        Vector256<float> lowest = Vector256.Create(Lowest);
        Vector256<float> highest = Vector256.Create(Highest);
        Vector256<float> allowed = Vector256<float>.AllBitsSet;
        Vector512<double> scale = Vector512.Create(_scale);
        Vector512<double> offset = Vector512.Create(_offset);
        int last = radii.Length - Vector256<float>.Count;
        fixed (double* target = radii)
        {
            for (int i = 0, next; ; i = next)
            {
                Vector256<float> values = TFormat.Eight(samples, i, _isReversed);
                allowed &= Vector256.GreaterThanOrEqual(values, lowest) & Vector256.LessThanOrEqual(values, highest); // NaN is neither
                Store(values, scale, offset, target + i);
                if (i == last)
                {
                    break;
                }

                next = Math.Min(i + Vector256<float>.Count, last);
            }
        }

        return allowed.AsUInt32() == Vector256<uint>.AllBitsSet;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(Vector256<float> values, Vector512<double> scale, Vector512<double> offset, double* radii)
    {
        if (Avx512F.IsSupported && Vector512.IsHardwareAccelerated)
        {
            (offset + (scale * Avx512F.ConvertToVector512Double(values))).Store(radii);
        }
        else
        {
            (offset.GetLower() + (scale.GetLower() * Avx.ConvertToVector256Double(values.GetLower()))).Store(radii);
            (offset.GetLower() + (scale.GetLower() * Avx.ConvertToVector256Double(values.GetUpper()))).Store(radii + 4);
        }
    }
}

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
