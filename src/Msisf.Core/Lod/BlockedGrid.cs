using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>A level of detail whose samples are kept in blocks of heights. Safe for several threads if its blocks are.</summary>
public abstract class BlockedGrid : IElevationGrid
{
    /// <summary>Describes the level.</summary>
    /// <param name="source">The model: its name and limits are the level's.</param>
    /// <param name="pixelsPerDegree">Samples a degree of the level.</param>
    protected BlockedGrid(IElevationGrid source, int pixelsPerDegree)
    {
        ProductId = source.ProductId;
        ReferenceRadius = source.ReferenceRadius;

        // A mean lies between the minimum and maximum of its samples, except for the rounding of its height.
        (double min, double max) = source.RadiusLimits;
        RadiusLimits = (min - Tolerances.VertexLattice, max + Tolerances.VertexLattice);
        Layout = new LodLayout(pixelsPerDegree);
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public int PixelsPerDegree => Layout.PixelsPerDegree;

    /// <inheritdoc/>
    public double ReferenceRadius { get; }

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits { get; }

    /// <summary>The level's blocks.</summary>
    protected LodLayout Layout { get; }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        Layout.CheckRange(line, 1, firstSample, radii.Length);
        int row = line >> LodLayout.SideShift;
        int start = (line & (LodLayout.Side - 1)) << LodLayout.SideShift;
        while (radii.Length > 0)
        {
            int column = firstSample >> LodLayout.SideShift;
            int inBlock = firstSample & (LodLayout.Side - 1);
            int count = Math.Min(radii.Length, Layout.SamplesOf(column) - inBlock);
            CopyRadii(HeightsOf(row, column).Slice(start + inBlock, count), radii);
            radii = radii[count..];
            firstSample = firstSample + count == Layout.Samples ? 0 : firstSample + count;
        }
    }

    /// <inheritdoc/>
    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples)
    {
        Layout.CheckRange(firstLine, lines, firstSample, samples);
        float min = float.PositiveInfinity;
        float max = float.NegativeInfinity;
        for (int line = firstLine, nextLine; line < firstLine + lines; line = nextLine)
        {
            nextLine = Math.Min(firstLine + lines, (line | (LodLayout.Side - 1)) + 1);
            for (int done = 0, count; done < samples; done += count)
            {
                int sample = (firstSample + done) % Layout.Samples;
                int column = sample >> LodLayout.SideShift;
                int inBlock = sample & (LodLayout.Side - 1);
                count = Math.Min(samples - done, Layout.SamplesOf(column) - inBlock);
                ReadOnlySpan<float> heights = HeightsOf(line >> LodLayout.SideShift, column);
                for (int i = line; i < nextLine; i++)
                {
                    foreach (float height in heights.Slice(((i & (LodLayout.Side - 1)) << LodLayout.SideShift) + inBlock, count))
                    {
                        min = Math.Min(min, height);
                        max = Math.Max(max, height);
                    }
                }
            }
        }

        return (ReferenceRadius + min, ReferenceRadius + max);
    }

    /// <summary>The samples of a block.</summary>
    /// <param name="row">From the north.</param>
    /// <param name="column">From the west.</param>
    /// <returns><see cref="LodLayout.BlockSamples"/> heights, m over the reference radius, <see cref="LodLayout.Side"/> a line.</returns>
    protected abstract ReadOnlySpan<float> HeightsOf(int row, int column);

    private void CopyRadii(ReadOnlySpan<float> heights, Span<double> radii)
    {
        int i = 0;
        if (Avx.IsSupported)
        {
            ref float source = ref MemoryMarshal.GetReference(heights);
            ref double target = ref MemoryMarshal.GetReference(radii);
            Vector256<double> reference = Vector256.Create(ReferenceRadius);
            for (; i <= heights.Length - Vector256<double>.Count; i += Vector256<double>.Count)
            {
                (reference + Avx.ConvertToVector256Double(Vector128.LoadUnsafe(ref source, (nuint)i))).StoreUnsafe(ref target, (nuint)i);
            }
        }

        for (; i < heights.Length; i++)
        {
            radii[i] = ReferenceRadius + heights[i];
        }
    }
}
