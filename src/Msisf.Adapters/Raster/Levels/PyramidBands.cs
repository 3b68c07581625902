using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>A level of detail while its sidecar is made: the last two rows of blocks, from which a row of the next level follows.</summary>
internal sealed class PyramidBands : BlockedGrid
{
    private readonly float[][] _bands;

    /// <param name="source">The model.</param>
    /// <param name="level">How many times its resolution is halved.</param>
    public PyramidBands(IGlobalGrid source, int level)
        : base(source, level)
    {
        int samples = Layout.BlockColumns * LodLayout.BlockSamples;
        _bands = [new float[samples], new float[samples]];
    }

    /// <summary>Blocks from west to east.</summary>
    public int Columns => Layout.BlockColumns;

    /// <summary>Blocks from north to south.</summary>
    public int Rows => Layout.BlockRows;

    /// <summary>The samples of a row of blocks, one block after the other.</summary>
    public Span<float> Row(int row) => _bands[row & 1];

    /// <summary>Computes a row of blocks.</summary>
    public void Fill(int row, BlockReducer reducer, ParallelOptions options)
    {
        float[] band = _bands[row & 1];
        if (Layout.SamplesOf(row, 0).Lines < LodLayout.Side)
        {
            Array.Clear(band); // what the last blocks lack is zero in the file
        }

        Parallel.For(
            0,
            Columns,
            options,
            column => reducer.Reduce(row, column, band.AsSpan(column * LodLayout.BlockSamples, LodLayout.BlockSamples)));
    }

    /// <inheritdoc/>
    protected override ReadOnlySpan<float> HeightsOf(int row, int column) =>
        _bands[row & 1].AsSpan(column * LodLayout.BlockSamples, LodLayout.BlockSamples);
}
