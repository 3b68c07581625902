using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>One level of a mapped sidecar. A block is checked when it is first read. Safe for several threads.</summary>
internal sealed unsafe class PyramidLevel : BlockedGrid, IGlobalGrid
{
    private readonly string _path;
    private readonly float* _blocks;
    private readonly uint[] _checksums;
    private readonly int _firstBlock;
    private readonly bool[] _isChecked;

    /// <param name="source">The model.</param>
    /// <param name="level">How many times the model's resolution is halved.</param>
    /// <param name="path">For messages.</param>
    /// <param name="blocks">The level's first block; valid as long as the level is used.</param>
    /// <param name="checksums">Of all levels' blocks.</param>
    /// <param name="firstBlock">Number of the level's first block among them.</param>
    public PyramidLevel(IGlobalGrid source, int level, string path, float* blocks, uint[] checksums, int firstBlock)
        : base(source, level)
    {
        PixelsPerDegree = source.PixelsPerDegree >> level;
        _path = path;
        _blocks = blocks;
        _checksums = checksums;
        _firstBlock = firstBlock;
        _isChecked = new bool[Layout.Blocks];
    }

    /// <inheritdoc/>
    public int PixelsPerDegree { get; }

    /// <summary>Checks all blocks.</summary>
    /// <exception cref="BadInputException">One is damaged.</exception>
    public void Verify()
    {
        for (int block = 0; block < _isChecked.Length; block++)
        {
            HeightsOf(block / Layout.BlockColumns, block % Layout.BlockColumns);
        }
    }

    /// <inheritdoc/>
    protected override ReadOnlySpan<float> HeightsOf(int row, int column)
    {
        int block = (row * Layout.BlockColumns) + column;
        ReadOnlySpan<float> heights = new(_blocks + ((long)block * LodLayout.BlockSamples), LodLayout.BlockSamples);

        // Two threads may check the same block; that does no harm.
        if (!_isChecked[block])
        {
            if (PyramidLayout.ChecksumOf(heights) != _checksums[_firstBlock + block])
            {
                throw new BadInputException(
                    $"{_path}: block {block} of the level of {PixelsPerDegree} px/deg is damaged. "
                        + $"Delete the file, or make it again with 'msis ldem pyramid'.");
            }

            _isChecked[block] = true;
        }

        return heights;
    }
}
