using System.Numerics;
using System.Runtime.InteropServices;
using Msisf.Core.Lod;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>
/// The layout of a sidecar: a page with the header, a checksum for each block, then the blocks, level by level from the finest one, each
/// level row by row. Blocks begin at pages and have their full size.
/// </summary>
/// <param name="PixelsPerDegree">Samples a degree of the model.</param>
internal readonly record struct PyramidLayout(int PixelsPerDegree)
{
    /// <summary>
    /// The first level that is stored. Level 1 would take half of the model's own size; it is computed, four samples for one.
    /// </summary>
    public const int FirstLevel = 2;

    public const int BlockBytes = sizeof(float) * LodLayout.BlockSamples;

    private const int PageBytes = 4096;

    /// <summary>Stored levels; 0 or less for a model with too few.</summary>
    public int LevelCount => LodLevels.CountOf(PixelsPerDegree) - FirstLevel;

    /// <summary>Blocks of all stored levels.</summary>
    public int BlockCount => FirstBlockOf(LevelCount);

    public static int ChecksumsOffset => PageBytes;

    public int ChecksumsBytes => BlockCount * sizeof(uint);

    public long BlocksOffset => (ChecksumsOffset + ChecksumsBytes + PageBytes - 1) / PageBytes * PageBytes;

    public long FileBytes => BlocksOffset + ((long)BlockCount * BlockBytes);

    /// <summary>The blocks of a stored level.</summary>
    /// <param name="index">0 is level <see cref="FirstLevel"/> of the model.</param>
    public LodLayout LevelAt(int index) => new(PixelsPerDegree >> (FirstLevel + index));

    /// <summary>Index of a level's first block among all stored blocks.</summary>
    public int FirstBlockOf(int index)
    {
        int first = 0;
        for (int level = 0; level < index; level++)
        {
            first += LevelAt(level).Blocks;
        }

        return first;
    }

    public long OffsetOf(int block) => BlocksOffset + ((long)block * BlockBytes);

    /// <summary>CRC-32C of a block's bytes.</summary>
    public static uint ChecksumOf(ReadOnlySpan<float> heights)
    {
        uint checksum = uint.MaxValue;
        foreach (ulong bytes in MemoryMarshal.Cast<float, ulong>(heights))
        {
            checksum = BitOperations.Crc32C(checksum, bytes);
        }

        return checksum;
    }
}
