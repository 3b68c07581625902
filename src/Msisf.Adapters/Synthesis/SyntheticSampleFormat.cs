using System.Buffers.Binary;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.Adapters.Synthesis;

/// <summary>How a synthetic product stores its heights, as the LOLA archive: in 16-bit steps of 0.5 m, or in 32-bit floats, km.</summary>
public sealed record SyntheticSampleFormat(LdemSampleType Type)
{
    private const double IntegerStep = 0.5; // m a unit
    private const double MetresPerKilometre = 1000.0;

    /// <summary>16-bit integers.</summary>
    public static SyntheticSampleFormat Integers { get; } = new(LdemSampleType.Int16LittleEndian);

    /// <summary>32-bit floats.</summary>
    public static SyntheticSampleFormat Floats { get; } = new(LdemSampleType.Float32LittleEndian);

    /// <summary>Whether the samples are integers.</summary>
    public bool IsInteger => Type == LdemSampleType.Int16LittleEndian;

    /// <summary>Bytes of a sample.</summary>
    public int SampleBytes => IsInteger ? sizeof(short) : sizeof(float);

    /// <summary>SAMPLE_TYPE of the label.</summary>
    public string TypeKeyword => IsInteger ? "LSB_INTEGER" : "PC_REAL";

    /// <summary>UNIT of the label.</summary>
    public string Unit => IsInteger ? "METER" : "KILOMETER";

    /// <summary>The unit as a word of the label's comments.</summary>
    public string UnitWord => IsInteger ? "meters" : "km";

    /// <summary>SCALING_FACTOR of the label.</summary>
    public string ScalingFactor => IsInteger ? "0.5" : "1";

    /// <summary>OFFSET of the label.</summary>
    /// <param name="referenceRadius">m.</param>
    public string OffsetOf(double referenceRadius) => IsInteger
        ? Invariant($"{referenceRadius:0}.")
        : Invariant($"{referenceRadius / MetresPerKilometre}");

    /// <summary>Writes a row of heights.</summary>
    /// <param name="line">Line in the whole Moon's grid, for messages.</param>
    /// <param name="firstSample">First sample in the whole Moon's grid, for messages.</param>
    /// <param name="heights">m over the reference radius.</param>
    /// <param name="bytes">Filled with the samples.</param>
    /// <returns>The minimum and the maximum sample, in the product's unit.</returns>
    /// <exception cref="BadInputException">A height does not fit 16 bits.</exception>
    public (double Minimum, double Maximum) Encode(int line, int firstSample, ReadOnlySpan<float> heights, Span<byte> bytes)
    {
        double minimum = double.PositiveInfinity;
        double maximum = double.NegativeInfinity;
        for (int i = 0; i < heights.Length; i++)
        {
            double sample = IsInteger ? ToInteger(heights[i], line, firstSample + i) : (float)(heights[i] / MetresPerKilometre);
            minimum = Math.Min(minimum, sample);
            maximum = Math.Max(maximum, sample);
            if (IsInteger)
            {
                BinaryPrimitives.WriteInt16LittleEndian(bytes[(sizeof(short) * i)..], (short)sample);
            }
            else
            {
                BinaryPrimitives.WriteSingleLittleEndian(bytes[(sizeof(float) * i)..], (float)sample);
            }
        }

        return (minimum, maximum);
    }

    /// <summary>A minimum or maximum as the label has it: the shortest text that reads back to the same sample.</summary>
    public string TextOf(double sample) =>
        IsInteger ? sample.ToString("0", CultureInfo.InvariantCulture) : ((float)sample).ToString("R", CultureInfo.InvariantCulture);

    private static double ToInteger(float height, int line, int sample)
    {
        double units = Math.Round(height / IntegerStep);
        return units is >= short.MinValue and <= short.MaxValue
            ? units
            : throw new BadInputException(Invariant(
                $"Line {line}, sample {sample}: the height {height} m does not fit 16 bits of 0.5 m. "
                    + $"Take --sample-type float32, another seed or another base."));
    }
}
