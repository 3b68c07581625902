using System.Globalization;
using System.Runtime.ExceptionServices;
using Msisf.Adapters.IO;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Tiles;

/// <summary>
/// The folder of pattern files: [root]/[res]/pattern_LDEM_[res]_lat_[a]_[b]_lon_[c]_[d].inc (docs/deviations.md, row 13).
/// Patterns are made when they are first needed and kept. Several threads and processes may use one repository at once:
/// a file appears whole under its name, and two that make the same one make the same bytes.
/// </summary>
public sealed class PatternRepository
{
    private static readonly TimeSpan StaleAge = TimeSpan.FromHours(1); // a pattern takes under a second

    private readonly string _root;

    /// <summary>Names the repository; the folder is made when the first pattern is written.</summary>
    /// <param name="root">Its folder.</param>
    public PatternRepository(string root) => _root = root;

    /// <summary>The folder of a resolution's patterns.</summary>
    public string FolderOf(int pixelsPerDegree) => Path.Combine(_root, pixelsPerDegree.ToString(CultureInfo.InvariantCulture));

    /// <summary>The file of a tile's pattern.</summary>
    public string PathOf(TileId tile, int pixelsPerDegree) => PathOf(SurfacePart.Whole(tile), pixelsPerDegree);

    /// <summary>The file of a part.</summary>
    /// <param name="part">Which.</param>
    /// <param name="pixelsPerDegree">Samples a degree of the model itself, whatever the part's level.</param>
    public string PathOf(SurfacePart part, int pixelsPerDegree) => Path.Combine(
        FolderOf(pixelsPerDegree),
        string.Create(CultureInfo.InvariantCulture, $"pattern_LDEM_{pixelsPerDegree}_{part.NameText}.inc"));

    /// <summary>Makes sure that the patterns are there, whole, and of these samples; makes those that are not.</summary>
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
        IElevationGrid grid,
        PatternOptions options,
        int maxParallelism,
        IProgress<int>? progress = null,
        CancellationToken cancellation = default)
    {
        TileMeshBuilder builder = new(grid);
        int resolution = grid.PixelsPerDegree;
        IEnumerable<PatternOrder> orders = tiles.Distinct().Order().Select(tile => new PatternOrder(
            PathOf(tile, resolution),
            TileMeshLayout.For(tile, resolution, options.MarginSamples(resolution)),
            builder,
            grid.ProductId,
            options.Format));
        return Ensure([.. orders], maxParallelism, progress, cancellation);
    }

    /// <summary>The same for parts of tiles at levels of detail, in the usual form and without margin.</summary>
    /// <param name="parts">The parts; double ones count once.</param>
    /// <param name="builders">Of the model and its levels.</param>
    /// <param name="maxParallelism">How many parts to work on at once, at least 1.</param>
    /// <param name="cancellation">Stops between two parts.</param>
    /// <exception cref="BadInputException">A file that this program has not made has a pattern's name, or the model is damaged.</exception>
    /// <exception cref="ExternalPartException">The repository can't be read or written.</exception>
    public PatternSet EnsureParts(IEnumerable<SurfacePart> parts, LevelMeshBuilders builders, int maxParallelism, CancellationToken cancellation)
    {
        IEnumerable<PatternOrder> orders = parts.Distinct().Order().Select(part => new PatternOrder(
            PathOf(part, builders.PixelsPerDegree),
            TileMeshLayout.For(part, builders.PixelsPerDegree),
            builders.Of(part.Level),
            builders.ProductId,
            PatternFormat.Mesh2));
        return Ensure([.. orders], maxParallelism, progress: null, cancellation);
    }

    private static PatternSet Ensure(PatternOrder[] orders, int maxParallelism, IProgress<int>? progress, CancellationToken cancellation)
    {
        int ready = 0;
        int written = 0;
        try
        {
            Parallel.ForEach(
                orders,
                new ParallelOptions { MaxDegreeOfParallelism = maxParallelism, CancellationToken = cancellation },
                order =>
                {
                    if (Ensure(order))
                    {
                        Interlocked.Increment(ref written);
                    }

                    progress?.Report(Interlocked.Increment(ref ready));
                });
        }
        catch (AggregateException exception)
        {
            // Which tiles fail first depends on the threads; for a repeatable message, take the first by text.
            ExceptionDispatchInfo.Throw(exception.InnerExceptions.OrderBy(inner => inner.Message, StringComparer.Ordinal).First());
        }

        if (written > 0)
        {
            RemoveStaleFiles(Path.GetDirectoryName(orders[0].Path)!);
        }

        return new PatternSet([.. orders.Select(order => order.Path)], written);
    }

    private static bool Ensure(PatternOrder order)
    {
        double[] radii = order.Builder.ReadRadii(order.Layout);
        byte[] header = PatternHeader.WithoutLength(order.Layout, radii, order.Builder.WallFootRadius, order.ProductId, order.Format);
        switch (PatternFile.Inspect(order.Path, header))
        {
            case PatternFile.State.Good:
                return false;
            case PatternFile.State.Foreign:
                throw new BadInputException($"{order.Path}: has a pattern's name, but this program has not made it, so it stays as it is. Move it away, or choose another pattern repository.");
            default:
                TileMesh mesh = order.Builder.Build(order.Layout, radii);
                MakeFolder(Path.GetDirectoryName(order.Path)!);
                AtomicFile.Write(order.Path, stream => PatternWriter.Write(stream, mesh, header, order.Format), flushToDisk: false);
                return true;
        }
    }

    private static void MakeFolder(string folder)
    {
        try
        {
            Directory.CreateDirectory(folder);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"{folder}: can't be made: {exception.Message} Choose another pattern repository.", exception);
        }
    }

    /// <summary>
    /// Removes what killed runs left. The age is taken by the file system's own clock, from the newest file of the folder,
    /// so it holds for shared folders too, where neither our clock nor our process numbers mean anything.
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
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // Another user's leftover is theirs to remove; the patterns themselves are all there.
            return;
        }
    }

    /// <summary>A file that is wanted.</summary>
    private readonly record struct PatternOrder(
        string Path, TileMeshLayout Layout, TileMeshBuilder Builder, string ProductId, PatternFormat Format);
}
