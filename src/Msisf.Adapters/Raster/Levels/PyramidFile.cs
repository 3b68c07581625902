using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>A model's sidecar (docs/elevation-models.md), mapped into memory. Don't use its levels after it is disposed.</summary>
public sealed unsafe class PyramidFile : IDisposable
{
    private readonly PyramidHeader _header;
    private readonly MappedFile _file;
    private readonly PyramidLevel[] _levels;

    private PyramidFile(string path, PyramidHeader header, FileStream stream, uint[] checksums, IGlobalGrid source)
    {
        (FilePath, _header, _file) = (path, header, new MappedFile(stream));
        PyramidLayout layout = new(header.PixelsPerDegree);
        _levels = [.. Enumerable.Range(0, layout.LevelCount).Select(index => new PyramidLevel(
            source, PyramidLayout.FirstLevel + index, path, (float*)(_file.Start + layout.OffsetOf(layout.FirstBlockOf(index))),
            checksums, layout.FirstBlockOf(index)))];
    }

    /// <summary>Where it is.</summary>
    public string FilePath { get; }

    /// <summary>The stored levels, finest first: level 2 of the model and all coarser ones.</summary>
    public IReadOnlyList<IGlobalGrid> Levels => _levels;

    /// <summary>Opens a sidecar if it is complete and of this model. Neither its samples nor the model's are read for that.</summary>
    /// <param name="problem">Why it can't be used; null if it can, or if there is none.</param>
    public static PyramidFile? TryOpen(string path, LdemImage image, out string? problem)
    {
        problem = null;
        FileStream? stream = null;
        PyramidFile? file = null;
        try
        {
            if (File.Exists(path))
            {
                stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read);
                (file, problem) = Open(path, stream, image);
            }
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            problem = $"can't be read: {exception.Message}";
        }
        finally
        {
            if (file is null)
            {
                stream?.Dispose();
            }
        }

        return file;
    }

    /// <summary>Reads the whole sidecar and the whole model, and compares both with the checksums that the sidecar was made with.</summary>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="BadInputException">A block is damaged, or the model's samples are others.</exception>
    public void Verify(LdemImage image, CancellationToken cancellation)
    {
        Array.ForEach(_levels, level => level.Verify());
        using LdemContentHash content = new(image);
        for (int line = 0; line < image.Lines; line += image.PixelsPerDegree)
        {
            cancellation.ThrowIfCancellationRequested();
            content.Append(line, image.PixelsPerDegree);
        }

        if (!content.Finish().SequenceEqual(_header.ContentHash))
        {
            throw new BadInputException(
                $"{FilePath}: it was made of other samples than {image.Set.Location} has now. Make it again with 'msis ldem pyramid'.");
        }
    }

    /// <summary>Unmaps the file.</summary>
    public void Dispose() => _file.Dispose();

    private static (PyramidFile? File, string? Problem) Open(string path, FileStream stream, LdemImage image)
    {
        Span<byte> head = stackalloc byte[PyramidHeader.Bytes];
        int length = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        if (PyramidHeader.TryRead(head[..length]) is not { } header)
        {
            return (null, "it is damaged, or no pyramid of this version");
        }

        if (header.PixelsPerDegree != image.PixelsPerDegree || !header.Fingerprint.SequenceEqual(SummarySource.Of(image.Set).Fingerprint()))
        {
            return (null, $"it is of another model, or {image.ProductId} was changed or copied since");
        }

        PyramidLayout layout = new(header.PixelsPerDegree);
        if (stream.Length != layout.FileBytes)
        {
            return (null, FormattableString.Invariant($"it has {stream.Length} bytes, {layout.FileBytes} expected"));
        }

        uint[] checksums = new uint[layout.BlockCount];
        stream.Position = PyramidLayout.ChecksumsOffset;
        stream.ReadExactly(MemoryMarshal.AsBytes(checksums.AsSpan()));
        return SHA256.HashData(MemoryMarshal.AsBytes(checksums.AsSpan())).AsSpan().SequenceEqual(header.ChecksumsHash)
            ? (new PyramidFile(path, header, stream, checksums, image), null)
            : (null, "it is damaged");
    }
}

/// <summary>One level of a mapped sidecar. A block is checked when it is first read. Safe for several threads.</summary>
internal sealed unsafe class PyramidLevel : BlockedGrid, IGlobalGrid
{
    private readonly string _path;
    private readonly float* _blocks;
    private readonly uint[] _checksums;
    private readonly int _firstBlock;
    private readonly bool[] _isChecked;

    /// <param name="source">The model.</param>
    /// <param name="level">How many times the model's resolution is halved.</param>
    /// <param name="path">For messages.</param>
    /// <param name="blocks">The level's first block; valid as long as the level is used.</param>
    /// <param name="checksums">Of all levels' blocks.</param>
    /// <param name="firstBlock">Number of the level's first block among them.</param>
    public PyramidLevel(IGlobalGrid source, int level, string path, float* blocks, uint[] checksums, int firstBlock)
        : base(source, level)
    {
        PixelsPerDegree = source.PixelsPerDegree >> level;
        (_path, _checksums, _firstBlock) = (path, checksums, firstBlock);
        _blocks = blocks;
        _isChecked = new bool[Layout.Blocks];
    }

    /// <inheritdoc/>
    public int PixelsPerDegree { get; }

    /// <summary>Checks all blocks.</summary>
    /// <exception cref="BadInputException">One is damaged.</exception>
    public void Verify()
    {
        for (int block = 0; block < _isChecked.Length; block++)
        {
            HeightsOf(block / Layout.BlockColumns, block % Layout.BlockColumns);
        }
    }

    /// <inheritdoc/>
    protected override ReadOnlySpan<float> HeightsOf(int row, int column)
    {
        int block = (row * Layout.BlockColumns) + column;
        ReadOnlySpan<float> heights = new(_blocks + ((long)block * LodLayout.BlockSamples), LodLayout.BlockSamples);

        // Two threads may check the same block; that does no harm.
        if (!_isChecked[block])
        {
            if (PyramidLayout.ChecksumOf(heights) != _checksums[_firstBlock + block])
            {
                throw new BadInputException(
                    $"{_path}: block {block} of the level of {PixelsPerDegree} px/deg is damaged. "
                        + $"Delete the file, or make it again with 'msis ldem pyramid'.");
            }

            _isChecked[block] = true;
        }

        return heights;
    }
}
