using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>16-bit integers of either byte order, eight at a time.</summary>
internal sealed unsafe class Int16SampleCodec : SampleCodec
{
    private readonly bool _isReversed;
    private readonly double _scale;
    private readonly double _offset;
    private readonly short _lowest;
    private readonly short _highest;

    public Int16SampleCodec(LdemLabel label, bool isReversed)
    {
        _isReversed = isReversed;
        _scale = label.ScalingFactor;
        _offset = label.Offset;
        _lowest = (short)Math.Ceiling(label.Minimum);
        _highest = (short)Math.Floor(label.Maximum);
    }

    public override double ValueAt(byte* sample) => Value(sample, 0);

    public override bool IsAllowed(double value) => value >= _lowest && value <= _highest;

    public override bool TryReadRadii(byte* samples, Span<double> radii) =>
        Avx2.IsSupported && radii.Length >= Vector128<short>.Count ? TryReadEights(samples, radii) : TryReadOnes(samples, radii);

    public override (double Minimum, double Maximum) Bounds(byte* first, long lineBytes, int lines, int samples)
    {
        short minimum = short.MaxValue;
        short maximum = short.MinValue;
        Vector128<short> minima = Vector128.Create(minimum);
        Vector128<short> maxima = Vector128.Create(maximum);
        for (int line = 0; line < lines; line++, first += lineBytes)
        {
            int i = 0;
            for (; i <= samples - Vector128<short>.Count; i += Vector128<short>.Count)
            {
                Vector128<short> values = Eight(first, i);
                minima = Vector128.Min(minima, values);
                maxima = Vector128.Max(maxima, values);
            }

            for (; i < samples; i++)
            {
                short value = Value(first, i);
                minimum = short.Min(minimum, value);
                maximum = short.Max(maximum, value);
            }
        }

        for (int i = 0; samples >= Vector128<short>.Count && i < Vector128<short>.Count; i++)
        {
            minimum = short.Min(minimum, minima[i]);
            maximum = short.Max(maximum, maxima[i]);
        }

        return (minimum, maximum);
    }

    private bool TryReadOnes(byte* samples, Span<double> radii)
    {
        bool areAllowed = true;
        for (int i = 0; i < radii.Length; i++)
        {
            short value = Value(samples, i);
            areAllowed &= value >= _lowest && value <= _highest;
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
        Vector128<short> lowest = Vector128.Create(_lowest);
        Vector128<short> highest = Vector128.Create(_highest);
        Vector128<short> outside = Vector128<short>.Zero;
        Vector512<double> scale = Vector512.Create(_scale);
        Vector512<double> offset = Vector512.Create(_offset);
        int last = radii.Length - Vector128<short>.Count;
        fixed (double* target = radii)
        {
            for (int i = 0, next; ; i = next)
            {
                Vector128<short> values = Eight(samples, i);
                outside |= Vector128.LessThan(values, lowest) | Vector128.GreaterThan(values, highest);
                Store(Avx2.ConvertToVector256Int32(values), scale, offset, target + i);
                if (i == last)
                {
                    break;
                }

                next = Math.Min(i + Vector128<short>.Count, last);
            }
        }

        return outside == Vector128<short>.Zero;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(Vector256<int> values, Vector512<double> scale, Vector512<double> offset, double* radii)
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
    private Vector128<short> Eight(byte* samples, int index)
    {
        Vector128<short> values = Vector128.Load((short*)samples + index);
        return _isReversed ? Vector128.ShiftLeft(values, 8) | Vector128.ShiftRightLogical(values, 8) : values;
    }

    private short Value(byte* samples, int index)
    {
        short value = Unsafe.ReadUnaligned<short>((short*)samples + index);
        return _isReversed ? BinaryPrimitives.ReverseEndianness(value) : value;
    }
}
