using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Adapters.Terrain;

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

    public override bool TryReadRadii(byte* samples, Span<double> radii)
    {
        Vector128<short> outside = Vector128<short>.Zero;
        int i = 0;
        if (Sse2.IsSupported)
        {
            for (; i <= radii.Length - Vector128<short>.Count; i += Vector128<short>.Count)
            {
                Vector128<short> values = Eight(samples, i);
                outside |= Vector128.LessThan(values, Vector128.Create(_lowest)) | Vector128.GreaterThan(values, Vector128.Create(_highest));
                (Vector128<int> lower, Vector128<int> upper) = Vector128.Widen(values);
                StoreRadii(lower, radii.Slice(i, 4));
                StoreRadii(upper, radii.Slice(i + 4, 4));
            }
        }

        bool areAllowed = outside == Vector128<short>.Zero;
        for (; i < radii.Length; i++)
        {
            short value = Value(samples, i);
            areAllowed &= value >= _lowest && value <= _highest;
            radii[i] = _offset + (_scale * value);
        }

        return areAllowed;
    }

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

    /// <summary>Four integers at a time: no hardware multiplies 16-bit integers into doubles.</summary>
    private void StoreRadii(Vector128<int> values, Span<double> radii)
    {
        Vector128<double> lower = Sse2.ConvertToVector128Double(values);
        Vector128<double> upper = Sse2.ConvertToVector128Double(Vector128.Shuffle(values, Vector128.Create(2, 3, 2, 3)));
        (Vector128.Create(_offset) + (_scale * lower)).CopyTo(radii);
        (Vector128.Create(_offset) + (_scale * upper)).CopyTo(radii[2..]);
    }

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
