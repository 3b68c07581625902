using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>A level of detail whose samples are kept in blocks of heights. Safe for several threads if its blocks are.</summary>
public abstract class BlockedGrid : ITerrainGrid
{
    private readonly ITerrainGrid _source;
    private readonly int _halvings;

    /// <summary>Describes the level.</summary>
    /// <param name="source">The model: its name and limits are the level's.</param>
    /// <param name="halvings">How many times the model's resolution is halved.</param>
    /// <param name="keepsGaps">Whether it has no data where the model has none; without it such a place is an error.</param>
    protected BlockedGrid(ITerrainGrid source, int halvings, bool keepsGaps)
    {
        (_source, _halvings) = (source, halvings);
        MayHaveGaps = keepsGaps && source.MayHaveGaps;
        ProductId = source.ProductId;
        ReferenceRadius = source.ReferenceRadius;

        // A mean lies between the minimum and maximum of its samples, except for the rounding of its height.
        (double min, double max) = source.RadiusLimits;
        RadiusLimits = (min - Tolerances.VertexLattice, max + Tolerances.VertexLattice);
        (Projection, Lines, Samples, Layout) = (source.Projection, source.Lines, source.Samples, LodLayout.Of(source));
        for (int halving = 0; halving < halvings; halving++)
        {
            Projection = Projection.Halved()
                ?? throw new ArgumentOutOfRangeException(nameof(halvings), $"{source.Projection} can't be halved {halvings} times.");
            (Lines, Samples, Layout) = ((Lines + 1) / 2, (Samples + 1) / 2, Layout.Halved());
        }
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public MapProjection Projection { get; }

    /// <inheritdoc/>
    public int Lines { get; }

    /// <inheritdoc/>
    public int Samples { get; }

    /// <inheritdoc/>
    public GridWindow Window => Layout.Window;

    /// <inheritdoc/>
    public double ReferenceRadius { get; }

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits { get; }

    /// <inheritdoc/>
    public bool MayHaveGaps { get; }

    /// <summary>The level's blocks.</summary>
    protected LodLayout Layout { get; }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        Layout.CheckRange(line, firstSample, radii.Length);
        int row = Layout.RowOf(line);
        GridWindow window = Layout.Window;
        while (radii.Length > 0)
        {
            int end = Math.Min((firstSample | (LodLayout.Side - 1)) + 1, window.EndSample);
            int count = Math.Min(radii.Length, end - firstSample);
            CopyRadii(
                HeightsOf(row, Layout.ColumnOf(firstSample)).Slice(LodLayout.IndexInBlock(line, firstSample), count), radii);
            if (MayHaveGaps && HasNaN(radii[..count]))
            {
                throw new BadInputException($"{ProductId}, line {line + 1} of a coarser level: no data there.");
            }

            radii = radii[count..];
            firstSample = firstSample + count == window.EndSample ? window.FirstSample : firstSample + count;
        }
    }

    /// <inheritdoc/>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        if (!MayHaveGaps)
        {
            isGap.Clear();
            return;
        }

        Layout.CheckRange(line, firstSample, isGap.Length);
        for (int i = 0; i < isGap.Length; i++)
        {
            int sample = firstSample + i < Layout.Window.EndSample ? firstSample + i : firstSample + i - Layout.Window.Samples;
            isGap[i] = float.IsNaN(
                HeightsOf(Layout.RowOf(line), Layout.ColumnOf(sample))[LodLayout.IndexInBlock(line, sample)]);
        }
    }

    /// <inheritdoc/>
    /// <remarks>Means of samples lie between them, and differ by no more than the samples that lie a coarse cell apart.</remarks>
    public KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples)
    {
        GridWindow all = _source.Window;
        int line = Math.Max(firstLine << _halvings, all.FirstLine);
        int sample = Math.Max(firstSample << _halvings, all.FirstSample);
        return _source.BoundsOf(
            line, Math.Min((firstLine + lines) << _halvings, all.EndLine) - line,
            sample, EndOf(firstSample + samples) - sample) is { } known
            ? new KnownBounds(
                known.Min - Tolerances.VertexLattice, known.Max + Tolerances.VertexLattice,
                (known.Step * (1 << _halvings)) + Tolerances.VertexLattice)
            : null;
    }

    /// <inheritdoc/>
    public bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples)
    {
        GridWindow all = _source.Window;
        int line = Math.Max(firstLine << _halvings, all.FirstLine);
        int sample = Math.Max(firstSample << _halvings, all.FirstSample);
        return MayHaveGaps && _source.MayHaveGapsIn(
            line, Math.Min((firstLine + lines) << _halvings, all.EndLine) - line,
            sample, EndOf(firstSample + samples) - sample);
    }

    /// <summary>The source's sample after those of a range; what goes all around goes on beyond its last sample.</summary>
    private int EndOf(int endSample) =>
        Layout.IsRing ? endSample << _halvings : Math.Min(endSample << _halvings, _source.Window.EndSample);

    /// <summary>The samples of a block.</summary>
    /// <param name="row">From the top.</param>
    /// <param name="column">From the left.</param>
    /// <returns><see cref="LodLayout.BlockSamples"/> heights, m over the reference radius, <see cref="LodLayout.Side"/> a line.</returns>
    protected abstract ReadOnlySpan<float> HeightsOf(int row, int column);

    private static bool HasNaN(ReadOnlySpan<double> radii)
    {
        foreach (double radius in radii)
        {
            if (double.IsNaN(radius))
            {
                return true;
            }
        }

        return false;
    }

    private void CopyRadii(ReadOnlySpan<float> heights, Span<double> radii)
    {
        int i = 0;
        if (Avx.IsSupported)
        {
            Vector256<double> reference = Vector256.Create(ReferenceRadius);
            for (; i <= heights.Length - Vector256<double>.Count; i += Vector256<double>.Count)
            {
                (reference + Avx.ConvertToVector256Double(ArrayLanes.Load128(heights, i))).StoreTo(radii, i);
            }
        }

        for (; i < heights.Length; i++)
        {
            radii[i] = ReferenceRadius + heights[i];
        }
    }
}
