using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Adapters.IO;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Makes the sidecar of a model: its levels of detail from the second on. The model is read and hashed once, from north to south; memory
/// holds two rows of blocks per level.
/// </summary>
public static class PyramidWriter
{
    /// <summary>Writes the sidecar completely or not at all. The same model gives the same levels.</summary>
    /// <param name="path">The sidecar's name; an older one is replaced.</param>
    /// <param name="threads">How many threads compute at most.</param>
    /// <param name="progress">Told the fraction done, 0 to 1.</param>
    /// <param name="cancellation">Stops the work; nothing is left behind.</param>
    /// <exception cref="BadInputException">The model is too coarse, changed while it was read, or a sample can't be right.</exception>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void Write(LdemImage image, string path, int threads, IProgress<double>? progress, CancellationToken cancellation)
    {
        PyramidLayout layout = PyramidLayout.OfMoon(image.PixelsPerDegree);
        if (layout.LevelCount < 1)
        {
            throw new BadInputException(
                $"{image.Set.Location}: a model of {image.PixelsPerDegree} px/deg has no levels that are worth a file. It needs none.");
        }

        byte[] fingerprint = ModelSource.Of(image.Set).Fingerprint();
        ParallelOptions options = new() { MaxDegreeOfParallelism = Math.Max(1, threads), CancellationToken = cancellation };
        try
        {
            AtomicFile.Write(path, stream => WriteFile(image, layout, stream, fingerprint, options, progress));
        }
        catch (AggregateException exception) when (
            exception.Flatten().InnerExceptions.FirstOrDefault(inner => inner is MsisfException or OperationCanceledException) is { } first)
        {
            ExceptionDispatchInfo.Throw(first);
        }
    }

    private static void WriteFile(
        LdemImage image, PyramidLayout layout, Stream stream, byte[] fingerprint, ParallelOptions options, IProgress<double>? progress)
    {
        PyramidRows rows = new(image, layout, stream, options);
        BlockReducer reducer = new(image, layout.FirstLevel);
        using LdemContentHash content = new(image);
        int bandLines = LodLayout.Side << layout.FirstLevel;
        for (int row = 0; row < rows.Count; row++)
        {
            Parallel.Invoke(
                () => content.Append(row * bandLines, Math.Min(bandLines, image.Lines - (row * bandLines))),
                () => rows.Finest.Fill(row, reducer, options));
            rows.Write(row);
            progress?.Report((row + 1.0) / rows.Count);
        }

        if (!ModelSource.Of(image.Set).Fingerprint().SequenceEqual(fingerprint))
        {
            throw new BadInputException(
                $"{image.Set.Location}: the model was changed while it was read. Start again when it is complete.");
        }

        rows.Finish(fingerprint, content.Finish());
    }
}

/// <summary>Writes a sidecar row of blocks by row of blocks, from which those of the coarser levels follow.</summary>
internal sealed class PyramidRows
{
    private readonly PyramidLayout _layout;
    private readonly Stream _stream;
    private readonly PyramidBands[] _levels;
    private readonly BlockReducer[] _reducers;
    private readonly uint[] _checksums;
    private readonly ParallelOptions _options;

    /// <summary>Begins a file.</summary>
    /// <param name="stream">It, empty.</param>
    public PyramidRows(ITerrainGrid model, PyramidLayout layout, Stream stream, ParallelOptions options)
    {
        (_layout, _stream, _options) = (layout, stream, options);
        _levels = [.. Enumerable.Range(layout.FirstLevel, layout.LevelCount).Select(level => new PyramidBands(model, level))];
        _reducers = [.. _levels.SkipLast(1).Select(below => new BlockReducer(below, 1, keepsGaps: true))];
        _checksums = new uint[layout.BlockCount];
        stream.SetLength(layout.FileBytes);
    }

    /// <summary>The finest level of the file, whose rows are to be filled one after the other.</summary>
    public PyramidBands Finest => _levels[0];

    /// <summary>Its number of rows of blocks.</summary>
    public int Count => Finest.Rows;

    /// <summary>Writes a row of its blocks, which is filled, and those of coarser levels that this completes.</summary>
    public void Write(int row) => Write(0, row);

    /// <summary>Writes the head.</summary>
    public void Finish(byte[] fingerprint, byte[] contentHash)
    {
        _stream.Position = 0;
        _stream.Write(new PyramidHeader(
            _layout.PixelsPerDegree, _layout.FirstLevel, fingerprint, contentHash, ChecksumsHash()).ToBytes());
        _stream.Position = PyramidLayout.ChecksumsOffset;
        _stream.Write(MemoryMarshal.AsBytes(_checksums.AsSpan()));
    }

    /// <summary>SHA-256 of the check sums of the blocks that were written.</summary>
    public byte[] ChecksumsHash() => SHA256.HashData(MemoryMarshal.AsBytes(_checksums.AsSpan()));

    private void Write(int level, int row)
    {
        PyramidBands bands = _levels[level];
        int firstBlock = _layout.FirstBlockOf(level) + (row * bands.Columns);
        Span<float> heights = bands.Row(row);
        if (level + 1 < _levels.Length && bands.RowAbove(row) is var above && (row == bands.Rows - 1 || bands.RowAbove(row + 1) != above))
        {
            _levels[level + 1].Fill(above, _reducers[level], _options);
            Write(level + 1, above);
        }

        for (int column = 0; column < bands.Columns; column++)
        {
            _checksums[firstBlock + column] = PyramidLayout.ChecksumOf(
                heights.Slice(column * LodLayout.BlockSamples, LodLayout.BlockSamples));
        }

        _stream.Position = _layout.OffsetOf(firstBlock);
        _stream.Write(MemoryMarshal.AsBytes(heights));
    }
}

/// <summary>A level of detail while its sidecar is made: the last two rows of blocks, from which a row of the next level follows.</summary>
internal sealed class PyramidBands : BlockedGrid
{
    private readonly float[][] _bands;

    /// <param name="source">The model.</param>
    /// <param name="level">How many times its resolution is halved.</param>
    public PyramidBands(ITerrainGrid source, int level)
        : base(source, level, keepsGaps: true)
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

    /// <summary>The samples of a block.</summary>
    public Span<float> Block(int row, int column) => Row(row).Slice(column * LodLayout.BlockSamples, LodLayout.BlockSamples);

    /// <summary>The row of blocks of the next level that a row belongs to.</summary>
    public int RowAbove(int row) => Layout.Halved().RowOf(Layout.SamplesOf(row, 0).FirstLine >> 1);

    /// <summary>The row of blocks in which a line of the model is.</summary>
    /// <param name="halvings">Number of this level.</param>
    public int RowOf(int modelLine, int halvings) => Layout.RowOf(modelLine >> halvings);

    /// <summary>The column of blocks in which a sample of the model is.</summary>
    /// <param name="halvings">Number of this level.</param>
    public int ColumnOf(int modelSample, int halvings) => Layout.ColumnOf(modelSample >> halvings);

    /// <summary>Makes room for a row of blocks; what blocks lack at the end of a model is zero in the file.</summary>
    public void Begin(int row)
    {
        if (Layout.SamplesOf(row, 0).Lines < LodLayout.Side)
        {
            Row(row).Clear();
        }
    }

    /// <summary>Computes a row of blocks.</summary>
    public void Fill(int row, BlockReducer reducer, ParallelOptions options)
    {
        Begin(row);
        Parallel.For(
            0,
            Columns,
            options,
            column => reducer.Reduce(row, column, Block(row, column)));
    }

    protected override ReadOnlySpan<float> HeightsOf(int row, int column) => Block(row, column);
}

/// <summary>
/// SHA-256 of a model's samples: each file's samples are hashed in the file's order, then these hashes in the order of the files.
/// </summary>
internal sealed class LdemContentHash(LdemImage image) : IDisposable
{
    private readonly IncrementalHash[] _hashes = [.. image.Parts.Select(_ => IncrementalHash.CreateHash(HashAlgorithmName.SHA256))];

    /// <summary>Adds lines of the whole Moon, from north to south, each once.</summary>
    public void Append(int firstLine, int lines)
    {
        foreach ((LdemPart part, IncrementalHash hash) in image.Parts.Zip(_hashes))
        {
            for (int line = Math.Max(firstLine, part.FirstLine); line < Math.Min(firstLine + lines, part.EndLine); line++)
            {
                hash.AppendData(part.LineBytes(line));
            }
        }
    }

    /// <summary>The hash of all that was added.</summary>
    public byte[] Finish() => SHA256.HashData([.. _hashes.SelectMany(hash => hash.GetCurrentHash())]);

    public void Dispose() => Array.ForEach(_hashes, hash => hash.Dispose());
}
