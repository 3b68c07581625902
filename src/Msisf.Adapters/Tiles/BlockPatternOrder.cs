using Msisf.Core.Blocks;

namespace Msisf.Adapters.Tiles;

/// <summary>A pattern of a block of a surface.</summary>
/// <param name="path">Its file.</param>
/// <param name="blocks">The surface.</param>
/// <param name="block">The block.</param>
internal sealed class BlockPatternOrder(string path, SceneBlocks blocks, SceneBlock block) : PatternOrder(path)
{
    /// <inheritdoc/>
    public override Content Read()
    {
        IReadOnlyList<BlockMesh> meshes = blocks.MeshesOf(block);
        byte[] header = PatternHeader.WithoutLength(blocks, block, meshes);
        return new Content(Path, header, () => stream => PatternWriter.Write(stream, meshes, header, isOneSided: !blocks.IsClosed));
    }
}
