using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>A coarser level of a map that was computed before, all of it in memory. Immutable.</summary>
public sealed class StoredLevel : BlockedGrid
{
    private readonly float[] _heights;

    /// <summary>Takes the samples.</summary>
    /// <param name="halvings">How many times its resolution is halved.</param>
    /// <param name="heights">
    /// m over the reference radius, NaN without data: the level's window line by line, as <see cref="BlockReducer"/> makes them.
    /// </param>
    public StoredLevel(ITerrainGrid map, int halvings, ReadOnlySpan<float> heights)
        : base(map, halvings, keepsGaps: true)
    {
        _heights = new float[Layout.Blocks * LodLayout.BlockSamples];
        GridWindow window = Layout.Window;
        for (int line = window.FirstLine; line < window.EndLine; line++)
        {
            for (int sample = window.FirstSample; sample < window.EndSample; sample++)
            {
                BlockStart(Layout.RowOf(line), Layout.ColumnOf(sample))[LodLayout.IndexInBlock(line, sample)] =
                    heights[((line - window.FirstLine) * window.Samples) + sample - window.FirstSample];
            }
        }
    }

    /// <inheritdoc/>
    protected override ReadOnlySpan<float> HeightsOf(int row, int column) => BlockStart(row, column);

    private Span<float> BlockStart(int row, int column) =>
        _heights.AsSpan(((row * Layout.BlockColumns) + column) * LodLayout.BlockSamples, LodLayout.BlockSamples);
}
