using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using Msisf.Core.Numerics;

namespace Msisf.Adapters.Terrain;

/// <summary>32-bit floats of either byte order.</summary>
internal sealed unsafe class Float32SampleCodec : SampleCodec
{
    private readonly bool isReversed;
    private readonly double scale;
    private readonly double offset;
    private readonly double lowest;
    private readonly double highest;

    public Float32SampleCodec(LdemLabel label, bool isReversed)
    {
        this.isReversed = isReversed;
        scale = label.ScalingFactor;
        offset = label.Offset;
        double slack = Tolerances.FloatSampleLimits * (label.Maximum - label.Minimum);
        lowest = label.Minimum - slack;
        highest = label.Maximum + slack;
    }

    public override double ValueAt(byte* sample) => Value(sample, 0);

    public override bool IsAllowed(double value) => value >= lowest && value <= highest;

    public override bool TryReadRadii(byte* samples, Span<double> radii)
    {
        bool areAllowed = true;
        for (int i = 0; i < radii.Length; i++)
        {
            double value = Value(samples, i);
            areAllowed &= IsAllowed(value);
            radii[i] = offset + (scale * value);
        }

        return areAllowed;
    }

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

    private double Value(byte* samples, int index)
    {
        uint bits = Unsafe.ReadUnaligned<uint>((uint*)samples + index);
        return BitConverter.UInt32BitsToSingle(isReversed ? BinaryPrimitives.ReverseEndianness(bits) : bits);
    }
}
