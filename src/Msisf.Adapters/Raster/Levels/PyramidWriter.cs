using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>
/// Makes the sidecar of a model: its levels of detail from the second on. The model is read and hashed once, from north to south; memory
/// holds two rows of blocks per level.
/// </summary>
public sealed class PyramidWriter
{
    private readonly LdemImage _image;
    private readonly PyramidLayout _layout;
    private readonly PyramidBands[] _levels;
    private readonly BlockReducer[] _reducers;
    private readonly uint[] _checksums;
    private readonly ParallelOptions _options;

    private PyramidWriter(LdemImage image, int threads, CancellationToken cancellation)
    {
        _image = image;
        _layout = new PyramidLayout(image.PixelsPerDegree);
        _levels = [.. Enumerable.Range(PyramidLayout.FirstLevel, _layout.LevelCount).Select(level => new PyramidBands(image, level))];
        _reducers =
        [
            new BlockReducer(image, PyramidLayout.FirstLevel),
            .. _levels.SkipLast(1).Select(below => new BlockReducer(below, 1)),
        ];
        _checksums = new uint[_layout.BlockCount];
        _options = new ParallelOptions { MaxDegreeOfParallelism = Math.Max(1, threads), CancellationToken = cancellation };
    }

    /// <summary>Writes the sidecar completely or not at all. The same model gives the same levels.</summary>
    /// <param name="path">The sidecar's name; an older one is replaced.</param>
    /// <param name="threads">How many threads compute at most.</param>
    /// <param name="progress">Told the fraction done, 0 to 1.</param>
    /// <param name="cancellation">Stops the work; nothing is left behind.</param>
    /// <exception cref="BadInputException">The model is too coarse, changed while it was read, or a sample can't be right.</exception>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void Write(LdemImage image, string path, int threads, IProgress<double>? progress, CancellationToken cancellation)
    {
        if (new PyramidLayout(image.PixelsPerDegree).LevelCount < 1)
        {
            throw new BadInputException(
                $"{image.Set.Location}: a model of {image.PixelsPerDegree} px/deg has no levels that are worth a file. It needs none.");
        }

        byte[] fingerprint = SummarySource.Of(image.Set).Fingerprint();
        PyramidWriter writer = new(image, threads, cancellation);
        try
        {
            AtomicFile.Write(path, stream => writer.WriteFile(stream, fingerprint, progress));
        }
        catch (AggregateException exception) when (
            exception.Flatten().InnerExceptions.FirstOrDefault(inner => inner is MsisfException or OperationCanceledException) is { } first)
        {
            ExceptionDispatchInfo.Throw(first);
        }
    }

    private void WriteFile(Stream stream, byte[] fingerprint, IProgress<double>? progress)
    {
        stream.SetLength(_layout.FileBytes);
        using LdemContentHash content = new(_image);
        int bandLines = LodLayout.Side << PyramidLayout.FirstLevel;
        int rows = _levels[0].Rows;
        for (int row = 0; row < rows; row++)
        {
            Parallel.Invoke(
                () => content.Append(row * bandLines, Math.Min(bandLines, _image.Lines - (row * bandLines))),
                () => _levels[0].Fill(row, _reducers[0], _options));
            WriteRow(stream, 0, row);
            progress?.Report((row + 1.0) / rows);
        }

        if (!SummarySource.Of(_image.Set).Fingerprint().SequenceEqual(fingerprint))
        {
            throw new BadInputException(
                $"{_image.Set.Location}: the model was changed while it was read. Start again when it is complete.");
        }

        ReadOnlySpan<byte> checksums = MemoryMarshal.AsBytes(_checksums.AsSpan());
        stream.Position = 0;
        stream.Write(new PyramidHeader(_image.PixelsPerDegree, fingerprint, content.Finish(), SHA256.HashData(checksums)).ToBytes());
        stream.Position = PyramidLayout.ChecksumsOffset;
        stream.Write(checksums);
    }

    /// <summary>Writes a row of blocks, and the row of the next level that it completes.</summary>
    private void WriteRow(Stream stream, int level, int row)
    {
        PyramidBands bands = _levels[level];
        int firstBlock = _layout.FirstBlockOf(level) + (row * bands.Columns);
        Span<float> heights = bands.Row(row);
        if (level + 1 < _levels.Length && ((row & 1) == 1 || row == bands.Rows - 1))
        {
            _levels[level + 1].Fill(row / 2, _reducers[level + 1], _options);
            WriteRow(stream, level + 1, row / 2);
        }

        for (int column = 0; column < bands.Columns; column++)
        {
            _checksums[firstBlock + column] = PyramidLayout.ChecksumOf(
                heights.Slice(column * LodLayout.BlockSamples, LodLayout.BlockSamples));
        }

        stream.Position = _layout.OffsetOf(firstBlock);
        stream.Write(MemoryMarshal.AsBytes(heights));
    }
}

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
