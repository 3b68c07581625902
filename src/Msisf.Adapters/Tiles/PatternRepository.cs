using Msisf.Adapters.IO;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Tiles;

/// <summary>
/// The folder of pattern files: [root]/[res]/pattern_LDEM_[res]_lat_[a]_[b]_lon_[c]_[d].inc (docs/deviations.md, row 13). Patterns are made
/// when they are first needed, and kept. Several threads and processes may use one repository at once: a file appears complete under its
/// name, and each is made once (docs/pattern-format.md). Make one object per process and folder: a second one would release the claims of
/// the first.
/// </summary>
public sealed class PatternRepository : IDisposable
{
    /// <summary>A file in the folder of a resolution that stays empty. A repository that was always complete has none.</summary>
    private const string ClaimsName = ".msisf-claims";


    private static readonly TimeSpan StaleAge = TimeSpan.FromHours(1); // a pattern takes under a second

    private readonly string _root;
    private readonly TimeSpan _longestWait;
    private readonly Dictionary<string, ClaimFile> _claims = [];

    /// <summary>Names the repository; the folder is made when the first pattern is written.</summary>
    public PatternRepository(string root)
        : this(root, PatternMaker.LongestWait)
    {
    }

    /// <summary>The same with another limit on waiting for a pattern that others make.</summary>
    internal PatternRepository(string root, TimeSpan longestWait)
    {
        _root = root;
        _longestWait = longestWait;
    }

    /// <summary>The folder of a resolution's patterns.</summary>
    public string FolderOf(int pixelsPerDegree) => FolderOf(pixelsPerDegree.ToString(CultureInfo.InvariantCulture));

    /// <summary>A folder of the repository.</summary>
    public string FolderOf(string name) => Path.Combine(_root, name);

    /// <summary>The file of a tile's pattern.</summary>
    public string PathOf(TileId tile, int pixelsPerDegree) => Path.Combine(
        FolderOf(pixelsPerDegree),
        Invariant($"pattern_LDEM_{pixelsPerDegree}_{tile.RangeText}.inc"));

    /// <summary>Makes the patterns that are missing, damaged, or made of other samples.</summary>
    /// <param name="tiles">The tiles; double ones count once.</param>
    /// <param name="grid">The elevation model.</param>
    /// <param name="options">Margin and form.</param>
    /// <param name="maxParallelism">How many tiles to work on at once, at least 1.</param>
    /// <param name="progress">Is told, from any thread, how many tiles are ready.</param>
    /// <param name="cancellation">Stops between two tiles.</param>
    /// <exception cref="BadInputException">A file that this program has not made has a pattern's name, or the model is damaged.</exception>
    /// <exception cref="ExternalPartException">The repository can't be read or written.</exception>
    public PatternSet EnsurePatterns(
        IEnumerable<TileId> tiles,
        IGlobalGrid grid,
        PatternOptions options,
        int maxParallelism,
        IProgress<int>? progress = null,
        CancellationToken cancellation = default)
    {
        TileMeshBuilder builder = new(grid);
        int resolution = grid.PixelsPerDegree;
        IEnumerable<PatternOrder> orders = tiles.Distinct().Order().Select(tile => OrderOf(
            PathOf(tile, resolution),
            TileMeshLayout.For(tile, resolution, options.MarginSamples(resolution)),
            builder,
            grid.ProductId,
            options.Format));
        return Ensure([.. orders], FolderOf(resolution), maxParallelism, progress, cancellation);
    }

    /// <summary>Releases all claims.</summary>
    public void Dispose()
    {
        foreach (ClaimFile claims in _claims.Values)
        {
            claims.Dispose();
        }
    }

    /// <summary>Makes the patterns of a folder that are missing, damaged, or made of other samples.</summary>
    /// <param name="orders">The patterns, each once.</param>
    /// <param name="maxParallelism">How many to work on at once, at least 1.</param>
    /// <param name="progress">Is told, from any thread, how many are ready.</param>
    /// <param name="cancellation">Stops between two patterns.</param>
    internal PatternSet Ensure(
        PatternOrder[] orders, string folder, int maxParallelism, IProgress<int>? progress, CancellationToken cancellation)
    {
        int written = new PatternMaker(() => ClaimsIn(folder), maxParallelism, _longestWait, cancellation).Ensure(orders, progress);
        if (written > 0)
        {
            RemoveStaleFiles(folder);
        }

        return new PatternSet([.. orders.Select(order => order.Path)], written);
    }

    /// <summary>A pattern of a tile.</summary>
    /// <param name="layout">What its mesh joins.</param>
    /// <param name="builder">Makes the mesh.</param>
    private static PatternOrder OrderOf(
        string path, TileMeshLayout layout, TileMeshBuilder builder, string productId, PatternFormat format) => new(path, () =>
    {
        double[] radii = builder.ReadRadii(layout);
        byte[] header = PatternHeader.WithoutLength(layout, radii, productId, format);
        return new PatternContent(header, () =>
        {
            TileMesh mesh = builder.Build(layout, radii);
            return stream => PatternWriter.Write(stream, mesh, header, format);
        });
    });

    /// <summary>The claims of a folder. Their file stays open: closing it would release every claim of the process on it.</summary>
    private ClaimFile ClaimsIn(string folder)
    {
        lock (_claims)
        {
            if (!_claims.TryGetValue(folder, out ClaimFile? claims))
            {
                FileErrors.ToExternalPart(
                    $"{folder}: can't be made; choose another pattern repository", () => Directory.CreateDirectory(folder));
                claims = ClaimFile.Open(Path.Combine(folder, ClaimsName));
                _claims.Add(folder, claims);
            }

            return claims;
        }
    }

    /// <summary>
    /// Removes the partial files of killed runs. Their age is measured by the file system's own clock, from the newest file of the folder,
    /// so it holds for shared folders, where neither our clock nor our process numbers mean anything.
    /// </summary>
    private static void RemoveStaleFiles(string folder)
    {
        FileInfo[] files = new DirectoryInfo(folder).GetFiles("pattern_*.inc");
        DateTime newest = files.Max(file => file.LastWriteTimeUtc);
        foreach (FileInfo file in files)
        {
            bool isPartial = Path.GetFileNameWithoutExtension(file.Name).EndsWith(AtomicFile.PartialMark, StringComparison.Ordinal);
            if (isPartial && newest - file.LastWriteTimeUtc > StaleAge)
            {
                TryDelete(file);
            }
        }
    }

    private static void TryDelete(FileInfo file)
    {
        try
        {
            file.Delete();
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            // Another user's leftover is theirs to remove; the patterns themselves are all there.
            return;
        }
    }
}

/// <summary>The patterns of a set of tiles, all present.</summary>
/// <param name="Paths">Their files, by latitude, then longitude.</param>
/// <param name="Written">How many were made now; the others were there already.</param>
public sealed record PatternSet(IReadOnlyList<string> Paths, int Written);
