using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Msisf.Core.Numerics;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>32-bit floats of either byte order, eight at a time.</summary>
internal sealed unsafe class Float32SampleCodec : SampleCodec
{
    private readonly bool _isReversed;
    private readonly double _scale;
    private readonly double _offset;
    private readonly float _lowest;
    private readonly float _highest;

    public Float32SampleCodec(LdemLabel label, bool isReversed)
    {
        _isReversed = isReversed;
        _scale = label.ScalingFactor;
        _offset = label.Offset;
        double slack = Tolerances.FloatSampleLimits * (label.Maximum - label.Minimum);
        _lowest = MinFrom(label.Minimum - slack);
        _highest = -MinFrom(-(label.Maximum + slack));
    }

    public override double ValueAt(byte* sample) => Value(sample, 0);

    public override bool IsAllowed(double value) => value >= _lowest && value <= _highest;

    public override bool TryReadRadii(byte* samples, Span<double> radii) =>
        Avx.IsSupported && radii.Length >= Vector256<float>.Count ? TryReadEights(samples, radii) : TryReadOnes(samples, radii);

    public override (double Minimum, double Maximum) Bounds(byte* first, long lineBytes, int lines, int samples)
    {
        double minimum = double.PositiveInfinity;
        double maximum = double.NegativeInfinity;
        for (int line = 0; line < lines; line++, first += lineBytes)
        {
            for (int i = 0; i < samples; i++)
            {
                double value = Value(first, i);
                minimum = Math.Min(minimum, value);
                maximum = Math.Max(maximum, value);
            }
        }

        return (minimum, maximum);
    }

    /// <summary>The smallest float that is not below a number: floats can be compared with it instead.</summary>
    private static float MinFrom(double limit) => (float)limit < limit ? MathF.BitIncrement((float)limit) : (float)limit;

    private bool TryReadOnes(byte* samples, Span<double> radii)
    {
        bool areAllowed = true;
        for (int i = 0; i < radii.Length; i++)
        {
            double value = Value(samples, i);
            areAllowed &= IsAllowed(value);
            radii[i] = _offset + (_scale * value);
        }

        return areAllowed;
    }

    /// <summary>As <see cref="Int16SampleCodec"/>: the last eight may overlap those before.</summary>
    private bool TryReadEights(byte* samples, Span<double> radii)
    {
        Vector256<float> lowest = Vector256.Create(_lowest);
        Vector256<float> highest = Vector256.Create(_highest);
        Vector256<float> allowed = Vector256<float>.AllBitsSet;
        Vector512<double> scale = Vector512.Create(_scale);
        Vector512<double> offset = Vector512.Create(_offset);
        int last = radii.Length - Vector256<float>.Count;
        fixed (double* target = radii)
        {
            for (int i = 0, next; ; i = next)
            {
                Vector256<float> values = Eight(samples, i);
                allowed &= Avx.Compare(values, lowest, FloatComparisonMode.OrderedGreaterThanOrEqualNonSignaling)
                    & Avx.Compare(values, highest, FloatComparisonMode.OrderedLessThanOrEqualNonSignaling); // NaN is neither
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<float> Eight(byte* samples, int index)
    {
        Vector256<float> values = Vector256.Load((float*)samples + index);
        return _isReversed
            ? Vector256.Shuffle(
                values.AsByte(),
                Vector256.Create(
                    (byte)3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12, 19, 18, 17, 16, 23, 22, 21, 20, 27, 26, 25, 24, 31, 30, 29,
                    28)).AsSingle()
            : values;
    }

    private double Value(byte* samples, int index)
    {
        uint bits = Unsafe.ReadUnaligned<uint>((uint*)samples + index);
        return BitConverter.UInt32BitsToSingle(_isReversed ? BinaryPrimitives.ReverseEndianness(bits) : bits);
    }
}
