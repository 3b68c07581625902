using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector;

/// <summary>The amplifier and the analogue-to-digital converter: electrons and read noise to digital numbers.</summary>
internal sealed class Converter(DetectorSettings settings)
{
    private const int Lanes = 8;
    private const int PixelsAtOnce = 4 * Lanes;
    private const byte AtHighestNumber = 1;
    private const byte AtFullWell = 2;

    /// <summary>Added to a small whole number, it leaves the number in the last bits.</summary>
    private const double WholeNumberShift = 1L << 52;

    private readonly double _perElectron = 1.0 / settings.Gain;
    private readonly double _readNoise = settings.ReadNoise;
    private readonly double _bias = settings.Bias + 0.5; // rounds to the nearest DN
    private readonly double _max = settings.MaxNumber;
    private readonly double _fullWell = settings.FullWell;

    /// <summary>Converts a part of a row.</summary>
    /// <param name="charge">Electrons.</param>
    /// <param name="deviates">Normal deviates for the read noise.</param>
    /// <param name="offsets">DN: offsets of the columns.</param>
    /// <param name="saturated">Receives the saturation, see <see cref="DetectorImage.Saturated"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be converted with unoptimised vectors
    public void Convert(
        ReadOnlySpan<double> charge, ReadOnlySpan<double> deviates, ReadOnlySpan<double> offsets, Span<ushort> numbers,
        Span<byte> saturated)
    {
        int start = 0;
        for (; start <= charge.Length - PixelsAtOnce; start += PixelsAtOnce)
        {
            Vector512<double> isSaturated = Vector512<double>.Zero;
            Vector512<ulong> first = Eight(charge, deviates, offsets, start, ref isSaturated);
            Vector512<ulong> second = Eight(charge, deviates, offsets, start + Lanes, ref isSaturated);
            Vector512<ulong> third = Eight(charge, deviates, offsets, start + (2 * Lanes), ref isSaturated);
            Vector512<ulong> fourth = Eight(charge, deviates, offsets, start + (3 * Lanes), ref isSaturated);
            Vector512.Narrow(Vector512.Narrow(first, second), Vector512.Narrow(third, fourth)).CopyTo(numbers[start..]);
            saturated.Slice(start, PixelsAtOnce).Clear();
            if (isSaturated.ExtractMostSignificantBits() != 0)
            {
                ConvertSingly(charge, deviates, offsets, numbers, saturated, start, start + PixelsAtOnce);
            }
        }

        ConvertSingly(charge, deviates, offsets, numbers, saturated, start, charge.Length);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector512<ulong> Eight(
        ReadOnlySpan<double> charge, ReadOnlySpan<double> deviates, ReadOnlySpan<double> offsets, int start,
        ref Vector512<double> isSaturated)
    {
        Vector512<double> electrons = Vector512.Create(charge.Slice(start, Lanes));
        Vector512<double> noise = Vector512.Create(_readNoise) * Vector512.Create(deviates.Slice(start, Lanes));
        Vector512<double> number = Vector512.Floor(
            ((electrons + noise) * Vector512.Create(_perElectron)) + Vector512.Create(_bias)
                + Vector512.Create(offsets.Slice(start, Lanes)));
        Vector512<double> max = Vector512.Create(_max);
        isSaturated |= Vector512.GreaterThanOrEqual(number, max)
            | Vector512.GreaterThanOrEqual(electrons, Vector512.Create(_fullWell));
        Vector512<double> held = Vector512.MaxNative(Vector512.MinNative(number, max), Vector512<double>.Zero);
        return (held + Vector512.Create(WholeNumberShift)).AsUInt64() & Vector512.Create((ulong)ushort.MaxValue);
    }

    private void ConvertSingly(
        ReadOnlySpan<double> charge, ReadOnlySpan<double> deviates, ReadOnlySpan<double> offsets, Span<ushort> numbers,
        Span<byte> saturated, int start, int end)
    {
        for (int i = start; i < end; i++)
        {
            double number = Math.Floor(((charge[i] + (_readNoise * deviates[i])) * _perElectron) + _bias + offsets[i]);
            numbers[i] = (ushort)Math.Clamp(number, 0.0, _max);
            saturated[i] = (byte)((number >= _max ? AtHighestNumber : 0) | (charge[i] >= _fullWell ? AtFullWell : 0));
        }
    }
}
