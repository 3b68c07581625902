using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>Finds the parts of pixels whose samples, a grid, were drawn as the pixels of a finer image. It is for one thread.</summary>
internal sealed class GridParts
{
    private readonly int[] _facetsOfPixel = new int[(SamplePattern.MaxVectors + 1) * SamplePattern.Lanes];
    private readonly double[] _inversesOfPixel = new double[(SamplePattern.MaxVectors + 1) * SamplePattern.Lanes];

    /// <summary>Finds the parts of the pixels of a band in which each sample of a grid was drawn as a pixel.</summary>
    /// <param name="band">The band.</param>
    /// <param name="pattern">The grid.</param>
    /// <param name="model">The camera, a pinhole.</param>
    /// <param name="parts">Receives the parts.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else wait for it
    public void Find(Band band, SamplePattern pattern, CameraModel model, PixelParts parts)
    {
        parts.Begin(band.Records);
        int across = pattern.Across;
        int corner = (across - 1) * (band.Stride + 1); // from the first sample of a pixel to the last
        ulong all = ulong.MaxValue >> (64 - pattern.Count);
        float reach = (float)pattern.Reach;
        double[] toRight = [.. Enumerable.Range(0, model.Width).Select(column => PixelParts.PlaceOf(column, 0.0, model).Across)];
        for (int row = band.FirstRow / across; row <= band.LastRow / across; row++)
        {
            parts.EnsureRoom(model.Width);
            double up = PixelParts.PlaceOf(0.0, row, model).Along;
            int start = band.IndexOf(0, row * across);
            for (int column = 0; column < model.Width; column++, start += across)
            {
                int facet = band.Facets[start];
                if (!IsWhole(band, start, across, facet))
                {
                    parts.EnsureRoom(pattern.Count + model.Width - column);
                    FindMixed(band, pattern, start, column, row, model, parts);
                }
                else if (facet != Band.NotRecorded)
                {
                    // The inverse depth is linear in the image: that of the centre is the mean of two opposite corners.
                    double inverse = 0.5 * (band.InverseDepths[start] + band.InverseDepths[start + corner]);
                    parts.Add((row * model.Width) + column, facet, all, 1.0, inverse, toRight[column], up, reach);
                }
            }
        }
    }

    /// <summary>Whether all samples of a pixel show the same facet, or none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsWhole(Band band, int start, int across, int facet)
    {
        ref int samples = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(band.Facets), start);
        uint wanted = (1u << across) - 1;
        for (int line = 0; line < across; line++)
        {
            // Behind each row there is room for a whole vector.
            Vector256<int> eight = Vector256.LoadUnsafe(ref Unsafe.Add(ref samples, line * band.Stride));
            if ((Vector256.Equals(eight, Vector256.Create(facet)).ExtractMostSignificantBits() & wanted) != wanted)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Finds the parts of a pixel that shows several facets.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FindMixed(
        Band band, SamplePattern pattern, int start, int column, int row, CameraModel model, PixelParts parts)
    {
        for (int line = 0; line < pattern.Across; line++)
        {
            // Whole vectors: what they write beyond a line is overwritten by the next one.
            int at = start + (line * band.Stride);
            Vector256.LoadUnsafe(ref band.Facets[at]).StoreUnsafe(ref _facetsOfPixel[line * pattern.Across]);
            Vector512.LoadUnsafe(ref band.InverseDepths[at]).StoreUnsafe(ref _inversesOfPixel[line * pattern.Across]);
        }

        double weight = 1.0 / pattern.Count;
        for (ulong left = ulong.MaxValue >> (64 - pattern.Count); left != 0;)
        {
            int facet = _facetsOfPixel[BitOperations.TrailingZeroCount(left)];
            ulong taken = left & SampleSums.SamplesOf(ref _facetsOfPixel[0], pattern.Vectors, facet);
            left &= ~taken;
            if (facet == Band.NotRecorded)
            {
                continue;
            }

            double perCount = 1.0 / BitOperations.PopCount(taken);
            (double right, double down, double inverse) = SampleSums.Sum(
                ref pattern.Right[0], ref pattern.Down[0], ref _inversesOfPixel[0], taken);
            (right, down) = (right * perCount, down * perCount);
            (double across, double along) = PixelParts.PlaceOf(column + right, row + down, model);
            parts.Add(
                (row * model.Width) + column, facet, taken, weight * BitOperations.PopCount(taken), inverse * perCount, across, along,
                SampleSums.ReachOf(taken, right, down, pattern));
        }
    }
}
