using System.Buffers;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// Halves the resolution of a model any number of times: a sample is the mean of the two by two samples that it covers, ((NW + SW) + (NE
/// + SE)) / 4, and its height over the reference radius is rounded to a 32-bit float. The steps are the same for any number of halvings
/// at once, so a level has the same bits whichever finer level it is computed from. Safe for several threads.
/// </summary>
/// <remarks>
/// Rounding: a height below 16 km is off by at most 2^-11 m a level, after ten levels by less than 2^-7 m, the step of the vertices.
/// Of 16-bit models with steps of 0.5 m the first four levels are exact.
/// </remarks>
public sealed class BlockReducer
{
    private readonly IElevationGrid _finer;
    private readonly int _halvings;
    private readonly LodLayout _layout;
    private readonly double _reference;

    /// <summary>Takes a model to reduce.</summary>
    /// <param name="finer">The model; 2 to the power of <paramref name="halvings"/> must divide its resolution.</param>
    /// <param name="halvings">At least 1.</param>
    public BlockReducer(IElevationGrid finer, int halvings)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(halvings, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(halvings, int.TrailingZeroCount(finer.PixelsPerDegree));
        _finer = finer;
        _reference = finer.ReferenceRadius;
        _halvings = halvings;
        _layout = new LodLayout(finer.PixelsPerDegree >> halvings);
    }

    /// <summary>Computes a block.</summary>
    /// <param name="blockRow">From the north.</param>
    /// <param name="blockColumn">From the west.</param>
    /// <param name="heights">
    /// Filled with m over the reference radius, <see cref="LodLayout.Side"/> a line; where a block is smaller, the rest is not changed.
    /// </param>
    /// <exception cref="BadInputException">A sample of the model can't be right.</exception>
    public void Reduce(int blockRow, int blockColumn, Span<float> heights)
    {
        int firstLine = blockRow << LodLayout.SideShift;
        int firstSample = blockColumn << LodLayout.SideShift;
        int samples = _layout.SamplesOf(blockColumn);
        Span<double> radii = stackalloc double[LodLayout.Side];
        double[] scratch = ArrayPool<double>.Shared.Rent(4 * (samples << _halvings));
        try
        {
            for (int line = 0; line < _layout.LinesOf(blockRow); line++)
            {
                ReadLine(_halvings, firstLine + line, firstSample, radii[..samples], scratch);
                Span<float> target = heights.Slice(line << LodLayout.SideShift, samples);
                for (int sample = 0; sample < samples; sample++)
                {
                    target[sample] = (float)(radii[sample] - _reference);
                }
            }
        }
        finally
        {
            ArrayPool<double>.Shared.Return(scratch);
        }
    }

    private void ReadLine(int halvings, int line, int firstSample, Span<double> radii, Span<double> scratch)
    {
        if (halvings == 0)
        {
            _finer.ReadRadii(line, firstSample, radii);
            return;
        }

        int fine = 2 * radii.Length;
        Span<double> north = scratch[..fine];
        Span<double> south = scratch.Slice(fine, fine);
        Span<double> rest = scratch[(2 * fine)..];
        ReadLine(halvings - 1, 2 * line, 2 * firstSample, north, rest);
        ReadLine(halvings - 1, (2 * line) + 1, 2 * firstSample, south, rest);
        Halve(north, south, radii);
    }

    private void Halve(ReadOnlySpan<double> north, ReadOnlySpan<double> south, Span<double> radii)
    {
        int i = 0;
        if (Avx2.IsSupported)
        {
            ref double northStart = ref MemoryMarshal.GetReference(north);
            ref double southStart = ref MemoryMarshal.GetReference(south);
            ref double target = ref MemoryMarshal.GetReference(radii);
            Vector256<double> reference = Vector256.Create(_reference);
            for (; i <= radii.Length - Vector256<double>.Count; i += Vector256<double>.Count)
            {
                Vector256<double> west = Vector256.LoadUnsafe(ref northStart, (nuint)(2 * i))
                    + Vector256.LoadUnsafe(ref southStart, (nuint)(2 * i));
                Vector256<double> east = Vector256.LoadUnsafe(ref northStart, (nuint)((2 * i) + 4))
                    + Vector256.LoadUnsafe(ref southStart, (nuint)((2 * i) + 4));

                // Neighbours are added within 128-bit lanes, which leaves the order 0, 2, 1, 3.
                Vector256<double> sums = Avx2.Permute4x64(Avx.HorizontalAdd(west, east), 0b11_01_10_00);
                Vector128<float> heights = Avx.ConvertToVector128Single((0.25 * sums) - reference);
                (reference + Avx.ConvertToVector256Double(heights)).StoreUnsafe(ref target, (nuint)i);
            }
        }

        for (; i < radii.Length; i++)
        {
            double sum = north[2 * i] + south[2 * i] + (north[(2 * i) + 1] + south[(2 * i) + 1]);
            radii[i] = _reference + (float)((0.25 * sum) - _reference);
        }
    }
}
