using System.Runtime.ExceptionServices;
using Msisf.Adapters.IO;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// What all pixels of a raster are, and its coarser levels: found by looking at all of them once, and kept in files if it is large. Safe
/// for several threads.
/// </summary>
/// <param name="blocks">The raster; closed with this.</param>
/// <param name="part">Its place, and what its values mean.</param>
internal sealed class RasterContent(RasterBlocks blocks, RasterPart part) : IDisposable
{
    /// <summary>Bytes of a file of levels at most: of larger rasters it begins with a coarser one.</summary>
    private const long MostLevelBytes = 6_000_000_000;

    /// <summary>It takes one part in so many of the space that is free, at most.</summary>
    private const int PartsOfSpace = 4;

    private readonly Lock _gate = new();
    private RasterScan? _scan;
    private PyramidFile? _levels;

    /// <summary>The pixels.</summary>
    public RasterBlocks Blocks => blocks;

    /// <summary>Whether what is found is kept for other runs; fewer pixels are looked at in some 0.1 s.</summary>
    public bool IsLarge => (long)blocks.Height * blocks.Width >= RasterScanFile.LeastPixels;

    /// <summary>The levels that are kept in a file, finest first.</summary>
    public IReadOnlyList<ITerrainGrid> Levels => _levels?.Levels ?? [];

    /// <summary>What is known of the pixels without looking at them; null if nothing is.</summary>
    public RasterScan? Known => Volatile.Read(ref _scan);

    /// <summary>What the pixels are; the first request looks at all of them.</summary>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public RasterScan Scan(CancellationToken cancellation = default)
    {
        if (Known is { } known)
        {
            return known;
        }

        lock (_gate)
        {
            return _scan ??= Look(null, 0, null, cancellation);
        }
    }

    /// <summary>Takes what was found in an earlier run, or looks at all pixels and keeps what is found.</summary>
    /// <param name="map">The raster, of which the levels are.</param>
    /// <param name="start">Starts the display of a work that takes long; what it returns is disposed at its end.</param>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    /// <exception cref="ExternalPartException">It can't be kept.</exception>
    public void Prepare(ITerrainGrid map, KeptRaster kept, Func<FractionDisplay> start, CancellationToken cancellation)
    {
        if (Find(map, kept) is not null)
        {
            return;
        }

        using FractionDisplay display = start();
        using AtomicFileSet files = new();
        PyramidLayout layout = PyramidLayout.OfMap(part, Math.Min(MostLevelBytes, kept.FreeBytes / PartsOfSpace));
        RasterScan? scan = null;
        if (layout.LevelCount > 0)
        {
            files.Write(kept.Levels.ForWriting(), stream =>
            {
                PyramidRows rows = Rows(layout, stream, cancellation);
                scan = Look(rows, layout.FirstLevel, display.Progress, cancellation);
                rows.Finish(kept.Fingerprint, new byte[kept.Fingerprint.Length]);
            }, flushToDisk: false);
        }

        scan ??= Look(null, 0, display.Progress, cancellation);
        files.Write(kept.Scan.ForWriting(), stream => RasterScanFile.Write(stream, kept.Fingerprint, scan), flushToDisk: false);
        files.Commit();
        Find(map, kept);
    }

    /// <summary>Takes what was found in an earlier run.</summary>
    /// <param name="map">The raster, of which the levels are.</param>
    /// <returns>The file in which it is; null if there is none that holds.</returns>
    public string? Find(ITerrainGrid map, KeptRaster kept)
    {
        if (kept.FindScan() is not { } found)
        {
            return null;
        }

        Volatile.Write(ref _scan, found.Scan); // levels ask the map where it has data
        _levels ??= kept.FindLevels(map);
        bool isWhole = _levels is not null || PyramidLayout.OfMap(part, long.MaxValue).LevelCount < 1;
        return isWhole ? found.Path : null;
    }

    /// <summary>Looks at all pixels again, and compares what is found with what is kept.</summary>
    /// <param name="map">The raster, of which the levels are.</param>
    /// <returns>The file; null if there is none that holds.</returns>
    /// <exception cref="BadInputException">They differ.</exception>
    public string? Verify(ITerrainGrid map, KeptRaster kept, CancellationToken cancellation)
    {
        if (Find(map, kept) is not { } path)
        {
            return null;
        }

        _levels?.VerifyBlocks();
        PyramidRows? rows = _levels is null ? null : Rows(_levels.Layout, Stream.Null, cancellation);
        bool isSame = Look(rows, _levels?.Layout.FirstLevel ?? 0, null, cancellation).IsSameAs(Known!)
            && (_levels is null || rows!.ChecksumsHash().SequenceEqual(_levels.ChecksumsHash));
        return isSame ? path : throw new BadInputException(
            $"{path}: does not hold what the pixels of {part.ProductId} are. Delete it, and make it again.");
    }

    /// <summary>Closes the files.</summary>
    public void Dispose()
    {
        _levels?.Dispose();
        blocks.Dispose();
    }

    private PyramidRows Rows(PyramidLayout layout, Stream stream, CancellationToken cancellation) => new(
        part, layout, stream,
        new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount, CancellationToken = cancellation });

    private RasterScan Look(PyramidRows? rows, int firstLevel, IProgress<double>? progress, CancellationToken cancellation)
    {
        try
        {
            return RasterScanner.Scan(blocks, part.Window, new RasterLevels(part, rows, firstLevel), progress, cancellation);
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<MsisfException>().FirstOrDefault() is { } first)
        {
            ExceptionDispatchInfo.Throw(first);
            throw;
        }
    }
}

/// <summary>Where it is kept what the pixels of a raster are.</summary>
/// <param name="Scan">The possible places of the scan.</param>
/// <param name="Levels">The possible places of the levels.</param>
/// <param name="Fingerprint">What the raster is.</param>
internal sealed record KeptRaster(SidecarPlaces Scan, SidecarPlaces Levels, byte[] Fingerprint)
{
    /// <summary>Bytes that are free where the levels are written; none if the system does not tell.</summary>
    public long FreeBytes
    {
        get
        {
            try
            {
                string folder = Path.GetDirectoryName(Path.GetFullPath(Levels.ForWriting()))!;
                Directory.CreateDirectory(folder);
                return DiskRoom.Of(folder);
            }
            catch (Exception exception) when (exception.IsFileError())
            {
                return 0;
            }
        }
    }

    /// <summary>The kept scan with its file; null if there is none, or none of this raster.</summary>
    public (string Path, RasterScan Scan)? FindScan() => Scan.Read(
        path => RasterScanFile.TryRead(path, Fingerprint) is { } scan ? Tuple.Create(path, scan) : null) is { } kept
            ? (kept.Item1, kept.Item2)
            : null;

    /// <summary>The kept levels; null if there are none, or none of this raster.</summary>
    public PyramidFile? FindLevels(ITerrainGrid map) => Levels.Read(path => PyramidFile.TryOpenOfMap(path, map, Fingerprint));
}
