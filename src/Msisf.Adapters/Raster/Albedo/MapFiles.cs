using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.IO;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in one PDS3 image, or in several tiles.</summary>
internal sealed class PdsMapFiles
{
    /// <summary>Most pixels of a map; one that has more is read at half its resolution, or less.</summary>
    private const long MaxPixels = int.MaxValue;

    private readonly MapTileSet _set;
    private readonly MapTileLayout? _layout;

    private PdsMapFiles(MapTileSet set)
    {
        _set = set;
        _layout = set.Labels.Count > 1 ? MapTileLayout.Of(set) : null;
        string[] images = _layout is null ? [Label.ImagePath] : [.. _layout.Tiles.Select(tile => tile.Label.ImagePath)];
        Files = new MapFiles(
            images is [var only] ? only : Path.Combine(Path.GetDirectoryName(images[0]) ?? string.Empty, set.Name), images);
        if (images.Length > MapLevelsHeader.MaxFiles)
        {
            throw new BadInputException(
                $"{Files.Place}: a map of {images.Length} tiles; up to {MapLevelsHeader.MaxFiles} are read. Give a coarser map.");
        }
    }

    /// <summary>The label of the map, or of one of its tiles, which are alike.</summary>
    public PdsMapLabel Label => _set.Labels[0];

    /// <summary>The files of the samples.</summary>
    public MapFiles Files { get; }

    /// <summary>What the map is called in messages.</summary>
    public string Name => _layout is null
        ? Path.GetFileName(Label.ImagePath)
        : $"{_set.Name}, {_set.Labels.Count} tiles";

    /// <summary>
    /// What the user should know of the tiles: which are left out, and whether the map is read at less than its resolution.
    /// </summary>
    public IReadOnlyList<string> Notes =>
    [
        .. ((string[])
        [
            _set.LeftOut.Count == 0
                ? string.Empty
                : $"Polar stereographic tiles are not read; left out: {FileNames.Listed(_set.LeftOut)}.",
            Halvings == 0
                ? string.Empty
                : $"{_set.Name} has {Size.Width} x {Size.Height} px, more than the {MaxPixels} that are read: it is drawn at "
                    + $"1/{1 << Halvings} of its resolution.",
        ]).Where(note => note.Length > 0),
    ];

    /// <summary>Finds the files of a map.</summary>
    /// <param name="path">Its file or its label, one of its tiles, or their folder.</param>
    /// <param name="bandNanometres">The band that is wanted of a folder, nm.</param>
    /// <returns>Null if the file is not a PDS3 label and has none.</returns>
    /// <exception cref="BadInputException">The tiles don't make up a map, or a label is wrong.</exception>
    public static PdsMapFiles? TryFind(string path, int bandNanometres) =>
        Directory.Exists(path) ? new PdsMapFiles(MapTileSet.InFolder(path, bandNanometres))
        : PdsMapLabel.TryRead(path) is { } label ? new PdsMapFiles(MapTileSet.WithSiblings(label))
        : null;

    /// <summary>Opens the map.</summary>
    /// <exception cref="BadInputException">An image is missing, unreadable, or shorter than its label says.</exception>
    public MapSource OpenSource()
    {
        MapSource source = _layout is null ? new PdsMapSource(Label) : new TiledMapSource(_layout);
        for (int i = 0; i < Halvings; i++)
        {
            source = new HalvedMapSource(source);
        }

        return source;
    }

    private (long Width, long Height) Size => _layout is null ? (Label.LineSamples, Label.Lines) : (_layout.Width, _layout.Height);

    /// <summary>How often width and height are halved so that the map has no more than the pixels that are read.</summary>
    private int Halvings
    {
        get
        {
            int halvings = 0;
            for ((long width, long height) = Size; width * height > MaxPixels; (width, height) = ((width + 1) / 2, (height + 1) / 2))
            {
                halvings++;
            }

            return halvings;
        }
    }
}

/// <summary>The files that hold the samples of a map.</summary>
/// <param name="Place">Path that stands for all of them: the file, or the folder with the name of the map.</param>
/// <param name="Paths">The files; those of tiles from the north, then from the west.</param>
internal sealed record MapFiles(string Place, IReadOnlyList<string> Paths)
{
    /// <summary>The files as they are now: their length in total, and a number that changes with each of them.</summary>
    /// <exception cref="BadInputException">One can't be read.</exception>
    public (long Bytes, long Written) State()
    {
        (string Name, long Bytes, long Written)[] files = OfEach(path =>
        {
            FileInfo file = new(path);
            return (file.Name, file.Length, file.LastWriteTimeUtc.Ticks);
        });
        string all = string.Join('\n', files.Select(file => $"{file.Name} {file.Bytes} {file.Written}"));
        return (
            files.Sum(file => file.Bytes),
            files is [var only] ? only.Written : BinaryPrimitives.ReadInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(all))));
    }

    /// <summary>SHA-256 of each file.</summary>
    /// <exception cref="BadInputException">One can't be read.</exception>
    public byte[][] Hashes() => OfEach(path => Convert.FromHexString(FileHash.Sha256Of(path)));

    /// <summary>
    /// The checksum of a map: that of its file; of several the SHA-256 of theirs as hexadecimal digits, one after the other.
    /// </summary>
    public static byte[] HashOf(IReadOnlyList<byte[]> hashes) => hashes is [var only]
        ? only
        : SHA256.HashData(Encoding.ASCII.GetBytes(string.Concat(hashes.Select(Convert.ToHexStringLower))));

    private T[] OfEach<T>(Func<string, T> of) => [.. Paths.Select(path => FileErrors.ToBadInput($"{path}: can't be read", () => of(path)))];
}
