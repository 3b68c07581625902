using Msisf.Adapters.Interop;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// A GeoTIFF with heights of a part of the Moon, read by GDAL block by block where samples are asked for; the blocks are kept in memory up
/// to a limit. Safe for several threads.
/// </summary>
public sealed class GeoTiffGrid : ITerrainGrid, IDisposable
{
    private const int BlockShift = 8;
    private const int BlockSide = 1 << BlockShift;

    /// <summary>Blocks that are kept, 256 MB; beyond that all are dropped.</summary>
    private const int MaxBlocks = 1024;

    private readonly GdalImage _file;
    private readonly GdalImage _image;
    private readonly string _path;
    private readonly GeoTiffPlacement _placement;
    private readonly Func<float, double> _radiusOf;
    private readonly bool _isRing;
    private readonly int _blockColumns;
    private readonly Lock _gate = new();
    private float[]?[]?[] _blocks;
    private int _blockCount;

    /// <param name="path">The file.</param>
    /// <param name="file">It.</param>
    /// <param name="image">It, or the warped one.</param>
    /// <param name="placement">Where the pixels of the image lie.</param>
    private GeoTiffGrid(string path, GdalImage file, GdalImage image, GeoTiffPlacement placement)
    {
        (_path, _file, _image, _placement) = (path, file, image, placement);
        ProductId = ProductIdOf(path);
        double metres = image.Unit.ToUpperInvariant() switch
        {
            "" or "M" or "METRE" or "METER" or "METRES" or "METERS" => 1.0,
            "KM" or "KILOMETRE" or "KILOMETER" or "KILOMETRES" or "KILOMETERS" => 1000.0,
            _ => throw new BadInputException($"{path}: its heights are in '{image.Unit}'; metres or kilometres are needed."),
        };
        (double factor, double offset) = image.Scale;
        _radiusOf = value => placement.SphereRadius + (metres * (offset + (factor * value)));
        _blockColumns = (image.Width + BlockSide - 1) >> BlockShift;
        _blocks = new float[]?[]?[(image.Height + BlockSide - 1) >> BlockShift];
        (Lines, Samples) = placement.Projection is Equirectangular cylinder
            ? (180 * cylinder.PixelsPerDegree, 360 * cylinder.PixelsPerDegree)
            : (image.Height, image.Width);
        _isRing = placement.Projection is Equirectangular && placement.Window.Samples == Samples;
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public MapProjection Projection => _placement.Projection;

    /// <inheritdoc/>
    public int Lines { get; }

    /// <inheritdoc/>
    public int Samples { get; }

    /// <inheritdoc/>
    public GridWindow Window => _placement.Window;

    /// <summary>m: radius of the sphere over which the file has its heights.</summary>
    public double SphereRadius => _placement.SphereRadius;

    /// <summary>
    /// The projection of the file, in PROJ's form, if its pixels lie on no grid that is read: the samples are then bilinear between
    /// pixels. Null if they are its pixels.
    /// </summary>
    public string? WarpedFrom { get; private init; }

    /// <summary>Whether a path is that of a TIFF, by its name.</summary>
    public static bool IsNameOf(string path) =>
        Path.GetExtension(path).ToUpperInvariant() is ".TIF" or ".TIFF";

    /// <summary>Name of the model in a file: the file's.</summary>
    public static string ProductIdOf(string path) => Path.GetFileNameWithoutExtension(path);

    /// <summary>Opens a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL is missing.</exception>
    /// <exception cref="BadInputException">
    /// The file is missing, no image, or not of a part of the Moon in a projection that is read.
    /// </exception>
    public static GeoTiffGrid Open(string path, string? libraryPath)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException($"{path}: there is no such file. Name an elevation model.");
        }

        GdalImage file = GdalImage.Open(path, libraryPath);
        GdalImage? warped = null;
        try
        {
            if (PlacementOf(path, file, out string otherForm) is { } own)
            {
                return new GeoTiffGrid(path, file, file, own);
            }

            warped = GeoTiffWarp.Of(path, file);
            return warped is not null && PlacementOf(path, warped, out _) is { } placement
                ? new GeoTiffGrid(path, file, warped, placement) { WarpedFrom = file.Projection() }
                : throw new BadInputException(otherForm);
        }
        catch
        {
            warped?.Dispose();
            file.Dispose();
            throw;
        }
    }

    /// <summary>The file as the label of a model, for its name, fingerprint and checksum.</summary>
    public LdemLabel ToLabel() => new(
        _path, _path, ImageOffset: 0, ProductId, CelestialBody.Moon, Projection.Resolution.PixelsPerDegree ?? 0, _image.Height,
        _image.Width, LdemSampleType.Float32LittleEndian, ScalingFactor: 1.0, SphereRadius, -MoonConstants.MaxRelief,
        MoonConstants.MaxRelief, Polar: Projection as PolarStereographic);

    /// <inheritdoc/>
    public bool MayHaveGaps => _image.NoData is not null;

    /// <inheritdoc/>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        for (int i = 0; i < isGap.Length; i++)
        {
            isGap[i] = float.IsNaN(ValueAt(line - Window.FirstLine, ColumnOf(firstSample + i)));
        }
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        int row = line - Window.FirstLine;
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)row, (uint)_image.Height, nameof(line));
        for (int i = 0; i < radii.Length; i++)
        {
            int column = ColumnOf(firstSample + i);
            float value = ValueAt(row, column);
            radii[i] = float.IsNaN(value) ? throw Hole(row, column) : _radiusOf(value);
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        _image.Dispose();
        _file.Dispose();
    }

    private static GeoTiffPlacement? PlacementOf(string path, GdalImage image, out string otherForm) =>
        GeoTiffPlacement.Find(path, image.Width, image.Height, image.GeoTransform(), image.Projection(), out otherForm);

    private int ColumnOf(int sample)
    {
        int column = sample - (_isRing ? _placement.RingStart : Window.FirstSample);
        column += _isRing && column < 0 ? Samples : 0;
        column -= _isRing && column >= Samples ? Samples : 0;
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)column, (uint)_image.Width, nameof(sample));
        return column;
    }

    /// <summary>The value of a pixel of the file; NaN without data.</summary>
    private float ValueAt(int row, int column) =>
        BlockAt(row, column)[((row & (BlockSide - 1)) << BlockShift) | (column & (BlockSide - 1))];

    private float[] BlockAt(int row, int column)
    {
        (int blockRow, int blockColumn) = (row >> BlockShift, column >> BlockShift);
        return Volatile.Read(ref Volatile.Read(ref _blocks)[blockRow]) is { } inRow && Volatile.Read(ref inRow[blockColumn]) is { } block
            ? block
            : ReadBlock(blockRow, blockColumn);
    }

    private float[] ReadBlock(int blockRow, int blockColumn)
    {
        lock (_gate)
        {
            if (_blocks[blockRow]?[blockColumn] is { } known)
            {
                return known;
            }

            int line = blockRow << BlockShift;
            int sample = blockColumn << BlockShift;
            int lines = Math.Min(BlockSide, _image.Height - line);
            int samples = Math.Min(BlockSide, _image.Width - sample);
            float[] values = new float[lines * samples];
            _image.Read(line, lines, sample, samples, values);
            float[] block = new float[BlockSide * BlockSide];
            for (int i = 0; i < lines; i++)
            {
                values.AsSpan(i * samples, samples).CopyTo(block.AsSpan(i * BlockSide));
            }

            if (++_blockCount > MaxBlocks)
            {
                Volatile.Write(ref _blocks, new float[]?[]?[_blocks.Length]);
                _blockCount = 1;
            }

            if (_blocks[blockRow] is null)
            {
                Volatile.Write(ref _blocks[blockRow], new float[]?[_blockColumns]);
            }

            Volatile.Write(ref _blocks[blockRow]![blockColumn], block);
            return block;
        }
    }

    /// <summary>NaN that the file does not declare is no hole for GDAL's tools either.</summary>
    private BadInputException Hole(int row, int column) => new(
        $"{_path}, line {row + 1}, sample {column + 1}: "
            + (_file.NoData is null
                ? $"NaN, which the file does not declare as its no-data value. Declare it, with gdal_edit.py -a_nodata nan {_path}: then a "
                    + "coarser model shows there (a second --ldem), or gdal_fillnodata.py fills it."
                : "no data there. Fill the hole, e.g. with gdal_fillnodata.py, or cut the file to what is whole, with gdal_translate "
                    + "-srcwin."));
}
