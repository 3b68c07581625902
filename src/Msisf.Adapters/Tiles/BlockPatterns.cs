using System.Security.Cryptography;
using System.Text;
using Msisf.Core.Blocks;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Tiles;

/// <summary>
/// The pattern files of the blocks of one surface, in a folder of the repository that has the name of its models. Thread-safe.
/// </summary>
public sealed class BlockPatterns
{
    /// <summary>Characters of a folder's or file's part that names models; file systems allow 255 in all.</summary>
    private const int MaxNameLength = 120;

    /// <summary>Characters of the part that names levels; few models have more.</summary>
    private const int MaxLevelsLength = 40;

    private readonly PatternRepository _repository;
    private readonly SceneBlocks _blocks;
    private readonly string _levels;

    /// <summary>Takes the surface.</summary>
    /// <param name="terrain">The same surface.</param>
    /// <param name="levels">The level of each model, e.g. "0-2-x"; empty for the models themselves.</param>
    public BlockPatterns(PatternRepository repository, SceneBlocks blocks, ITerrain terrain, string levels = "")
    {
        _repository = repository;
        _blocks = blocks;
        _levels = levels.Length == 0 ? string.Empty : $"_levels_{Shortened(levels, levels, MaxLevelsLength)}";
        FolderName = FolderNameOf(terrain);
    }

    /// <summary>Name of the folder in the repository.</summary>
    public string FolderName { get; }

    /// <summary>The folder.</summary>
    public string Folder => _repository.FolderOf(FolderName);

    /// <summary>File name of a block's pattern, without folder.</summary>
    public string FileNameOf(SceneBlock block) => _blocks.ProductIdOf(block) is { } product
        ? Invariant($"pattern_{block.Part}_{NameOf(product)}{_levels}_block_{block.Row}_{block.Column}.inc")
        : Invariant($"pattern_{block.Part}{_levels}_seams_{block.Column}.inc");

    /// <summary>Name of the folder of a surface, which has the patterns of all its levels.</summary>
    public static string FolderNameOf(ITerrain terrain) => NameOf(terrain.ProductId);

    /// <summary>Makes the patterns that are missing, damaged, or made of other samples.</summary>
    /// <param name="maxParallelism">How many to work on at once, at least 1.</param>
    /// <param name="cancellation">Stops between two patterns.</param>
    /// <exception cref="BadInputException">A file that this program has not made has a pattern's name, or a model is damaged.</exception>
    /// <exception cref="ExternalPartException">The repository can't be read or written.</exception>
    public PatternSet Ensure(IEnumerable<SceneBlock> blocks, int maxParallelism, CancellationToken cancellation) => _repository.Ensure(
        [.. blocks.Select(OrderOf)],
        Folder,
        maxParallelism,
        progress: null,
        cancellation);

    /// <summary>
    /// The name of models as a part of a file's name: letters, digits, '.', '-' and '_'; a long one ends with its checksum.
    /// </summary>
    internal static string NameOf(string productId)
    {
        StringBuilder name = new(productId.Replace("+", "_and_", StringComparison.Ordinal));
        for (int i = 0; i < name.Length; i++)
        {
            name[i] = char.IsAsciiLetterOrDigit(name[i]) || (i > 0 && name[i] is '.' or '-') ? name[i] : '_';
        }

        return Shortened(name.ToString(), productId, MaxNameLength);
    }

    private PatternOrder OrderOf(SceneBlock block) => new(Path.Combine(Folder, FileNameOf(block)), () =>
    {
        IReadOnlyList<BlockMesh> meshes = _blocks.MeshesOf(block);
        byte[] header = PatternHeader.WithoutLength(_blocks, block, meshes);
        return new PatternContent(header, () => stream => PatternWriter.Write(stream, meshes, header, isOneSided: !_blocks.IsClosed));
    });

    /// <summary>A name; a long one is cut off, and ends with the checksum of what it names.</summary>
    private static string Shortened(string name, string named, int maxLength)
    {
        if (name.Length <= maxLength)
        {
            return name;
        }

        string checksum = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(named)))[..16];
        return $"{name[..(maxLength - checksum.Length - 1)]}_{checksum}";
    }
}
