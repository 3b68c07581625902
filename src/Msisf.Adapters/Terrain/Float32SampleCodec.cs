using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using Msisf.Core.Numerics;

namespace Msisf.Adapters.Terrain;

/// <summary>32-bit floats of either byte order.</summary>
internal sealed unsafe class Float32SampleCodec : SampleCodec
{
    private readonly bool _isReversed;
    private readonly double _scale;
    private readonly double _offset;
    private readonly double _lowest;
    private readonly double _highest;

    public Float32SampleCodec(LdemLabel label, bool isReversed)
    {
        _isReversed = isReversed;
        _scale = label.ScalingFactor;
        _offset = label.Offset;
        double slack = Tolerances.FloatSampleLimits * (label.Maximum - label.Minimum);
        _lowest = label.Minimum - slack;
        _highest = label.Maximum + slack;
    }

    public override double ValueAt(byte* sample) => Value(sample, 0);

    public override bool IsAllowed(double value) => value >= _lowest && value <= _highest;

    public override bool TryReadRadii(byte* samples, Span<double> radii)
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
        return BitConverter.UInt32BitsToSingle(_isReversed ? BinaryPrimitives.ReverseEndianness(bits) : bits);
    }
}
