namespace Msisf.Adapters.Raster.Heights;

/// <summary>Reads the sample values of one kind of elevation model; the addresses need not be aligned. Safe for several threads.</summary>
internal abstract unsafe class SampleCodec
{
    /// <summary>The codec for a label's samples.</summary>
    public static SampleCodec For(LdemLabel label) => label.SampleType switch
    {
        LdemSampleType.Int16LittleEndian => new Int16SampleCodec(label, isReversed: !BitConverter.IsLittleEndian),
        LdemSampleType.Int16BigEndian => new Int16SampleCodec(label, isReversed: BitConverter.IsLittleEndian),
        LdemSampleType.Float32LittleEndian => new Float32SampleCodec(label, isReversed: !BitConverter.IsLittleEndian),
        LdemSampleType.Float32BigEndian => new Float32SampleCodec(label, isReversed: BitConverter.IsLittleEndian),
        _ => throw new ArgumentOutOfRangeException(nameof(label)),
    };

    /// <summary>The value of one sample.</summary>
    public abstract double ValueAt(byte* sample);

    /// <summary>Whether the label allows a value.</summary>
    public abstract bool IsAllowed(double value);

    /// <summary>offset + scale * value for consecutive samples.</summary>
    /// <returns>False if a value is not allowed.</returns>
    public abstract bool TryReadRadii(byte* samples, Span<double> radii);

    /// <summary>Minimum and maximum value of a block; NaN if one is NaN.</summary>
    public abstract (double Minimum, double Maximum) Bounds(byte* first, long lineBytes, int lines, int samples);
}
