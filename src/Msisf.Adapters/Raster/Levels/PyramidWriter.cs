using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Lod;

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
    /// <param name="image">The model.</param>
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
                () => content.Append(row * bandLines, Math.Min(bandLines, (180 * _image.PixelsPerDegree) - (row * bandLines))),
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
