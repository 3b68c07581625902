using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>A model's sidecar (docs/elevation-models.md), mapped into memory. Don't use its levels after it is disposed.</summary>
public sealed class PyramidFile : IDisposable
{
    /// <summary>Name of the file, behind that of the model.</summary>
    public const string Extension = ".pyramid";

    private readonly PyramidHeader _header;
    private readonly MappedFile _file;
    private readonly PyramidLevel[] _levels;

    private PyramidFile(
        string path, PyramidHeader header, FileStream stream, uint[] checksums, PyramidLayout layout, ITerrainGrid source)
    {
        (FilePath, _header, Layout, _file) = (path, header, layout, new MappedFile(stream));
        _levels = [.. Enumerable.Range(0, layout.LevelCount).Select(index =>
        {
            StoredBlocks blocks = new(
                path, _file, layout.OffsetOf(layout.FirstBlockOf(index)), checksums.AsMemory(layout.FirstBlockOf(index)));
            return source is IGlobalGrid moon
                ? new MoonPyramidLevel(moon, layout.FirstLevel + index, blocks)
                : new PyramidLevel(source, layout.FirstLevel + index, blocks);
        })];
    }

    /// <summary>Where it is.</summary>
    public string FilePath { get; }

    /// <summary>The stored levels, finest first: level 2 of a model of the whole Moon and all coarser ones.</summary>
    public IReadOnlyList<ITerrainGrid> Levels => _levels;

    /// <summary>What is where in the file.</summary>
    internal PyramidLayout Layout { get; }

    /// <summary>SHA-256 of the blocks' check sums.</summary>
    internal byte[] ChecksumsHash => _header.ChecksumsHash;

    /// <summary>Opens a sidecar if it is complete and of this model. Neither its samples nor the model's are read for that.</summary>
    /// <param name="problem">Why it can't be used; null if it can, or if there is none.</param>
    public static PyramidFile? TryOpen(string path, LdemImage image, out string? problem) => TryOpen(
        path, image, ModelSource.Of(image.Set).Fingerprint(), _ => PyramidLayout.OfMoon(image.PixelsPerDegree), out problem);

    /// <summary>Opens the sidecar of a map.</summary>
    /// <param name="fingerprint">Fingerprint of the map.</param>
    internal static PyramidFile? TryOpenOfMap(string path, ITerrainGrid map, byte[] fingerprint) => TryOpen(
        path, map, fingerprint, firstLevel => PyramidLayout.OfMap(map, long.MaxValue).From(firstLevel), out _);

    private static PyramidFile? TryOpen(
        string path, ITerrainGrid model, byte[] fingerprint, Func<int, PyramidLayout> layoutFrom, out string? problem)
    {
        problem = null;
        FileStream? stream = null;
        PyramidFile? file = null;
        try
        {
            if (File.Exists(path))
            {
                stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read);
                (file, problem) = Open(path, stream, model, fingerprint, layoutFrom);
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
        VerifyBlocks();
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

    /// <summary>Reads all blocks and compares them with their checksums.</summary>
    /// <exception cref="BadInputException">A block is damaged.</exception>
    internal void VerifyBlocks() => Array.ForEach(_levels, level => level.Verify());

    /// <summary>Unmaps the file.</summary>
    public void Dispose() => _file.Dispose();

    private static (PyramidFile? File, string? Problem) Open(
        string path, FileStream stream, ITerrainGrid model, byte[] fingerprint, Func<int, PyramidLayout> layoutFrom)
    {
        Span<byte> head = stackalloc byte[PyramidHeader.Bytes];
        int length = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        if (PyramidHeader.TryRead(head[..length]) is not { } header)
        {
            return (null, "it is damaged, or no pyramid of this version");
        }

        PyramidLayout layout = layoutFrom(header.FirstLevel);
        if ((header.PixelsPerDegree, header.FirstLevel) != (layout.PixelsPerDegree, layout.FirstLevel)
            || !header.Fingerprint.SequenceEqual(fingerprint))
        {
            return (null, $"it is of another model, or {model.ProductId} was changed or copied since");
        }

        if (stream.Length != layout.FileBytes)
        {
            return (null, Invariant($"it has {stream.Length} bytes, {layout.FileBytes} expected"));
        }

        uint[] checksums = new uint[layout.BlockCount];
        stream.Position = PyramidLayout.ChecksumsOffset;
        stream.ReadExactly(MemoryMarshal.AsBytes(checksums.AsSpan()));
        return SHA256.HashData(MemoryMarshal.AsBytes(checksums.AsSpan())).AsSpan().SequenceEqual(header.ChecksumsHash)
            ? (new PyramidFile(path, header, stream, checksums, layout, model), null)
            : (null, "it is damaged");
    }
}

/// <summary>The blocks of a level in a mapped sidecar. A block is checked when it is first read. Safe for several threads.</summary>
/// <param name="path">For messages.</param>
/// <param name="offset">Offset of the level's first block in the file, bytes.</param>
/// <param name="checksums">Checksums of the level's blocks, and of those behind them.</param>
internal sealed unsafe class StoredBlocks(string path, MappedFile file, long offset, Memory<uint> checksums)
{
    private readonly bool[] _isChecked = new bool[checksums.Length];

    /// <summary>The heights of a block.</summary>
    /// <param name="level">Resolution of the level, for messages.</param>
    /// <exception cref="BadInputException">It is damaged.</exception>
    public ReadOnlySpan<float> HeightsOf(int block, GridResolution level)
    {
        ReadOnlySpan<float> heights =
            new((float*)(file.Start + offset) + ((long)block * LodLayout.BlockSamples), LodLayout.BlockSamples);

        // Two threads may check the same block; that does no harm.
        if (!_isChecked[block])
        {
            if (PyramidLayout.ChecksumOf(heights) != checksums.Span[block])
            {
                throw new BadInputException(
                    $"{path}: block {block} of the level of {level} is damaged. "
                        + $"Delete the file, or make it again with 'msis ldem pyramid'.");
            }

            _isChecked[block] = true;
        }

        return heights;
    }

    /// <summary>Releases the pages that were read.</summary>
    public void ReleasePages() => file.ReleasePages();
}

/// <summary>One level of a mapped sidecar. Safe for several threads.</summary>
/// <param name="source">The model.</param>
/// <param name="level">How many times the model's resolution is halved.</param>
/// <param name="blocks">Valid as long as the level is used.</param>
internal class PyramidLevel(ITerrainGrid source, int level, StoredBlocks blocks) : BlockedGrid(source, level, keepsGaps: true), ITerrainGrid
{
    public void ReleasePages() => blocks.ReleasePages();

    /// <summary>Checks all blocks.</summary>
    /// <exception cref="BadInputException">One is damaged.</exception>
    public void Verify()
    {
        for (int block = 0; block < Layout.Blocks; block++)
        {
            blocks.HeightsOf(block, Projection.Resolution);
        }
    }

    protected sealed override ReadOnlySpan<float> HeightsOf(int row, int column) =>
        blocks.HeightsOf((row * Layout.BlockColumns) + column, Projection.Resolution);
}

/// <summary>One level of a mapped sidecar of a model of the whole Moon.</summary>
/// <inheritdoc cref="PyramidLevel"/>
internal sealed class MoonPyramidLevel(IGlobalGrid source, int level, StoredBlocks blocks)
    : PyramidLevel(source, level, blocks), IGlobalGrid
{
    public int PixelsPerDegree { get; } = source.PixelsPerDegree >> level;
}
