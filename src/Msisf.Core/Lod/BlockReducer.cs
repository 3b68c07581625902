using System.Buffers;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// Halves the resolution of a model any number of times: a sample is the mean of the two by two samples that it covers, ((NW + SW) + (NE
/// + SE)) / 4, and its height over the reference radius is rounded to a 32-bit float. The steps are the same for any number of halvings
/// at once, so a level has the same bits whichever finer level it is computed from. Where a map ends in the middle of the two by two, the
/// samples that it has stand for the others. Safe for several threads.
/// </summary>
/// <remarks>
/// Rounding: a height below 16 km is off by at most 2^-11 m a level, after ten levels by less than 2^-7 m, the step of the vertices.
/// The first four levels of 16-bit models with steps of 0.5 m are exact.
/// </remarks>
public sealed class BlockReducer
{
    /// <summary>Number of samples of the finer model that are fetched together, at most, before they are read.</summary>
    private const int SamplesFetched = 1 << 22;

    private readonly ITerrainGrid _finer;
    private readonly int _halvings;
    private readonly LodLayout[] _layouts;
    private readonly double _reference;
    private readonly bool _keepsGaps;

    /// <summary>Takes a model to reduce.</summary>
    /// <param name="finer">
    /// The model; 2 to the power of <paramref name="halvings"/> must divide the resolution of one in simple cylindrical projection.
    /// </param>
    /// <param name="halvings">At least 1.</param>
    /// <param name="keepsGaps">
    /// Whether samples may be without data: a mean is of those that have some, and NaN where none has.
    /// </param>
    public BlockReducer(ITerrainGrid finer, int halvings, bool keepsGaps = false)
    {
        _keepsGaps = keepsGaps && finer.MayHaveGaps;
        ArgumentOutOfRangeException.ThrowIfLessThan(halvings, 1);
        _finer = finer;
        _reference = finer.ReferenceRadius;
        _halvings = halvings;
        _layouts = new LodLayout[halvings + 1];
        _layouts[0] = LodLayout.Of(finer);
        MapProjection? projection = finer.Projection;
        for (int halving = 1; halving <= halvings; halving++)
        {
            projection = projection.Halved()
                ?? throw new ArgumentOutOfRangeException(nameof(halvings), $"{finer.Projection} can't be halved {halvings} times.");
            _layouts[halving] = _layouts[halving - 1].Halved();
        }
    }

    /// <summary>Computes a block.</summary>
    /// <param name="blockRow">From the top.</param>
    /// <param name="blockColumn">From the left.</param>
    /// <param name="heights">
    /// Filled with m over the reference radius, <see cref="LodLayout.Side"/> a line; where a block is smaller, the rest is not changed.
    /// </param>
    /// <exception cref="BadInputException">A sample of the model can't be right.</exception>
    public void Reduce(int blockRow, int blockColumn, Span<float> heights)
    {
        GridWindow block = _layouts[_halvings].SamplesOf(blockRow, blockColumn);
        int samples = block.Samples;
        Span<double> radii = stackalloc double[LodLayout.Side];
        double[] scratch = ArrayPool<double>.Shared.Rent(4 * (samples << _halvings));
        try
        {
            int linesFetched = (int)Math.Max(1L, SamplesFetched / ((long)samples << (2 * _halvings)));
            for (int line = block.FirstLine; line < block.EndLine; line++)
            {
                if ((line - block.FirstLine) % linesFetched == 0)
                {
                    Prefetch(block with { FirstLine = line, EndLine = Math.Min(line + linesFetched, block.EndLine) });
                }

                ReadLine(_halvings, line, block.FirstSample, radii[..samples], scratch);
                Span<float> target = heights.Slice(LodLayout.IndexInBlock(line, block.FirstSample), samples);
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

    /// <summary>Tells the finer model that the samples of some of ours are read next.</summary>
    private void Prefetch(GridWindow reduced)
    {
        GridWindow all = _layouts[0].Window;
        int firstLine = Math.Max(reduced.FirstLine << _halvings, all.FirstLine);
        int firstSample = Math.Max(reduced.FirstSample << _halvings, all.FirstSample);
        _finer.Prefetch(
            firstLine,
            Math.Min(reduced.EndLine << _halvings, all.EndLine) - firstLine,
            firstSample,
            Math.Min(reduced.EndSample << _halvings, all.EndSample) - firstSample);
    }

    private void ReadLine(int halvings, int line, int firstSample, Span<double> radii, Span<double> scratch)
    {
        if (halvings == 0)
        {
            if (_keepsGaps)
            {
                ReadWithGaps(line, firstSample, radii);
            }
            else
            {
                _finer.ReadRadii(line, firstSample, radii);
            }

            return;
        }

        int fine = 2 * radii.Length;
        Span<double> north = scratch[..fine];
        Span<double> south = scratch.Slice(fine, fine);
        Span<double> rest = scratch[(2 * fine)..];
        GridWindow window = _layouts[halvings - 1].Window;
        ReadFine(halvings - 1, Math.Max(2 * line, window.FirstLine), 2 * firstSample, north, rest);
        ReadFine(halvings - 1, Math.Min((2 * line) + 1, window.EndLine - 1), 2 * firstSample, south, rest);
        Halve(north, south, radii);
    }

    /// <summary>Reads a line to be halved; at the end of a map the last sample stands for the one that is missing beside it.</summary>
    private void ReadFine(int halvings, int line, int firstSample, Span<double> radii, Span<double> scratch)
    {
        GridWindow window = _layouts[halvings].Window;
        int before = Math.Max(0, window.FirstSample - firstSample);
        int after = Math.Max(0, firstSample + radii.Length - window.EndSample);
        ReadLine(halvings, line, firstSample + before, radii[before..^after], scratch);
        if (before > 0)
        {
            radii[0] = radii[before];
        }

        if (after > 0)
        {
            radii[^1] = radii[^(1 + after)];
        }
    }

    private void ReadWithGaps(int line, int firstSample, Span<double> radii)
    {
        bool[] gaps = ArrayPool<bool>.Shared.Rent(radii.Length);
        Span<bool> isGap = gaps.AsSpan(0, radii.Length);
        _finer.ReadGaps(line, firstSample, isGap);
        radii.Fill(double.NaN);
        for (int start = isGap.IndexOf(false); start < radii.Length && start >= 0;)
        {
            int count = isGap[start..].IndexOf(true);
            int end = count < 0 ? radii.Length : start + count;
            _finer.ReadRadii(line, firstSample + start, radii[start..end]);
            int next = isGap[end..].IndexOf(false);
            start = next < 0 ? radii.Length : end + next;
        }

        ArrayPool<bool>.Shared.Return(gaps);
    }

    /// <summary>
    /// The radius that stands for four: ((NW + SW) + (NE + SE)) / 4, of those that have data, its height rounded to a 32-bit float; NaN if
    /// none has.
    /// </summary>
    public static double MeanOf(double northWest, double southWest, double northEast, double southEast, double reference)
    {
        double sum = northWest + southWest + (northEast + southEast);
        if (!double.IsNaN(sum))
        {
            return reference + (float)((0.25 * sum) - reference);
        }

        return MeanOfRest([northWest, southWest, northEast, southEast], reference);
    }

    private static double MeanOfRest(ReadOnlySpan<double> radii, double reference)
    {
        (double sum, int count) = (0.0, 0);
        foreach (double radius in radii)
        {
            if (!double.IsNaN(radius))
            {
                sum += radius;
                count++;
            }
        }

        return count == 0 ? double.NaN : reference + (float)((sum / count) - reference);
    }

    private void HalveWithGaps(ReadOnlySpan<double> north, ReadOnlySpan<double> south, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] = MeanOf(north[2 * i], south[2 * i], north[(2 * i) + 1], south[(2 * i) + 1], _reference);
        }
    }

    private void Halve(ReadOnlySpan<double> north, ReadOnlySpan<double> south, Span<double> radii)
    {
        if (_keepsGaps)
        {
            HalveWithGaps(north, south, radii);
            return;
        }

        int i = 0;
        if (Avx2.IsSupported)
        {
            Vector256<double> reference = Vector256.Create(_reference);
            for (; i <= radii.Length - Vector256<double>.Count; i += Vector256<double>.Count)
            {
                Vector256<double> west = ArrayLanes.Load256(north, 2 * i) + ArrayLanes.Load256(south, 2 * i);
                Vector256<double> east = ArrayLanes.Load256(north, (2 * i) + 4) + ArrayLanes.Load256(south, (2 * i) + 4);

                // Neighbours are added within 128-bit lanes, which leaves the order 0, 2, 1, 3.
                Vector256<double> sums = Avx2.Permute4x64(Avx.HorizontalAdd(west, east), 0b11_01_10_00);
                Vector128<float> heights = Avx.ConvertToVector128Single((0.25 * sums) - reference);
                (reference + Avx.ConvertToVector256Double(heights)).StoreTo(radii, i);
            }
        }

        for (; i < radii.Length; i++)
        {
            double sum = north[2 * i] + south[2 * i] + (north[(2 * i) + 1] + south[(2 * i) + 1]);
            radii[i] = _reference + (float)((0.25 * sum) - _reference);
        }
    }
}
