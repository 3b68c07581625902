using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Adapters.Terrain;

/// <summary>16-bit integers of either byte order, eight at a time.</summary>
internal sealed unsafe class Int16SampleCodec : SampleCodec
{
    private readonly bool isReversed;
    private readonly double scale;
    private readonly double offset;
    private readonly short lowest;
    private readonly short highest;

    public Int16SampleCodec(LdemLabel label, bool isReversed)
    {
        this.isReversed = isReversed;
        scale = label.ScalingFactor;
        offset = label.Offset;
        lowest = (short)Math.Ceiling(label.Minimum);
        highest = (short)Math.Floor(label.Maximum);
    }

    public override double ValueAt(byte* sample) => Value(sample, 0);

    public override bool IsAllowed(double value) => value >= lowest && value <= highest;

    public override bool TryReadRadii(byte* samples, Span<double> radii)
    {
        Vector128<short> outside = Vector128<short>.Zero;
        int i = 0;
        if (Sse2.IsSupported)
        {
            for (; i <= radii.Length - Vector128<short>.Count; i += Vector128<short>.Count)
            {
                Vector128<short> values = Eight(samples, i);
                outside |= Vector128.LessThan(values, Vector128.Create(lowest)) | Vector128.GreaterThan(values, Vector128.Create(highest));
                (Vector128<int> lower, Vector128<int> upper) = Vector128.Widen(values);
                StoreRadii(lower, radii.Slice(i, 4));
                StoreRadii(upper, radii.Slice(i + 4, 4));
            }
        }

        bool areAllowed = outside == Vector128<short>.Zero;
        for (; i < radii.Length; i++)
        {
            short value = Value(samples, i);
            areAllowed &= value >= lowest && value <= highest;
            radii[i] = offset + (scale * value);
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
        (Vector128.Create(offset) + (scale * lower)).CopyTo(radii);
        (Vector128.Create(offset) + (scale * upper)).CopyTo(radii[2..]);
    }

    private Vector128<short> Eight(byte* samples, int index)
    {
        Vector128<short> values = Vector128.Load((short*)samples + index);
        return isReversed ? Vector128.ShiftLeft(values, 8) | Vector128.ShiftRightLogical(values, 8) : values;
    }

    private short Value(byte* samples, int index)
    {
        short value = Unsafe.ReadUnaligned<short>((short*)samples + index);
        return isReversed ? BinaryPrimitives.ReverseEndianness(value) : value;
    }
}
