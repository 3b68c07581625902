using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// A raster with heights of a part of the Moon that GDAL reads, block by block where samples are asked for. Values that can't be heights
/// are without data. Safe for several threads.
/// </summary>
public sealed class GeoTiffGrid : ITerrainGrid, IDisposable
{
    private readonly RasterContent _content;
    private readonly string _path;
    private readonly GeoTiffPlacement _placement;
    private readonly HeightRule _rule;

    private GeoTiffGrid(string path, OpenedRaster raster, Func<OpenedRaster> open, HeightOptions given)
    {
        (_path, _placement, Given) = (path, raster.Placement, given);
        ProductId = RasterFiles.ProductIdOf(path);
        Files = raster.File.Files();
        WarpedFrom = raster.IsWarped ? raster.File.Projection() : null;
        _rule = HeightRule.Of(
            path, raster.File, given, raster.Placement.Projection.Resolution.MetresPerPixel, raster.Placement.SphereRadius);
        HasUnit = HeightUnit.Of(path, raster.File, given).IsKnown || raster.File.Scale != (1.0, 0.0);
        Bands = raster.File.Bands;
        RasterBlocks blocks = new(raster, open, _rule);
        (Lines, Samples) = _placement.Projection is Equirectangular cylinder
            ? (180 * cylinder.PixelsPerDegree, 360 * cylinder.PixelsPerDegree)
            : (blocks.Height, blocks.Width);
        _content = new RasterContent(blocks, new RasterPart(this, _rule, _placement.SphereRadius));
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public bool HoldsMeans => Given.HoldsMeans ?? RasterProducts.HoldsMeans(ProductId);

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
    public string? WarpedFrom { get; }

    /// <summary>The files of which the raster is made: itself first, then those that it names.</summary>
    public IReadOnlyList<string> Files { get; }

    /// <summary>What the user says of the values.</summary>
    public HeightOptions Given { get; }

    /// <summary>Whether somebody says in which unit its heights are: the file, its name or the user.</summary>
    public bool HasUnit { get; }

    /// <summary>Number of bands; heights are those of the first.</summary>
    public int Bands { get; }

    /// <summary>
    /// A note on the pixels that can't be heights and that the file does not declare; null if there are none. The first request looks at
    /// all pixels.
    /// </summary>
    public string? NoteOfGaps()
    {
        UndeclaredGaps gaps = _content.Scan().Undeclared;
        return gaps.Count == 0 ? null : UndeclaredGaps.NoteOf(ProductId, gaps);
    }

    /// <summary>Opens a file.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <param name="given">What the user says of its values.</param>
    /// <exception cref="ExternalPartException">GDAL is missing.</exception>
    /// <exception cref="BadInputException">
    /// The file is missing, is not an image or not of a part of the Moon in a known projection, or its values are not heights.
    /// </exception>
    public static GeoTiffGrid Open(string path, string? libraryPath, HeightOptions given = default)
    {
        if (!RasterFiles.Exists(path))
        {
            throw new BadInputException(RasterFiles.IsAddress(path)
                ? $"{path}: an address; write /vsicurl/{path} to read the file over the network, or get it and name the file."
                : $"{path}: there is no such file. Name an elevation model.");
        }

        path = RasterFiles.LabelOrFile(path);
        OpenedRaster raster = OpenedRaster.Open(path, libraryPath);
        try
        {
            if (!RasterFiles.IsVirtual(path) && raster.File.IsEmpty(0, raster.File.Height, 0, raster.File.Width))
            {
                throw new BadInputException(
                    $"{path}: a sparse file of {raster.File.Width} x {raster.File.Height} pixels that stores none of them. Get it again.");
            }

            return new GeoTiffGrid(path, raster, () => OpenedRaster.Open(path, libraryPath), given);
        }
        catch
        {
            raster.Dispose();
            throw;
        }
    }

    /// <summary>Looks at all pixels, or at what was found in an earlier run; of a large raster it is kept for the next ones.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    /// <param name="start">Starts the display of a work that takes long; what it returns is disposed at its end.</param>
    /// <returns>Why it could not be kept; null if it was, or need not be.</returns>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public string? Prepare(string? cacheFolder, Func<FractionDisplay> start, CancellationToken cancellation = default)
    {
        if (!IsLarge)
        {
            _content.Scan(cancellation);
            return null;
        }

        try
        {
            _content.Prepare(this, Kept(cacheFolder), start, cancellation);
            return null;
        }
        catch (Exception exception) when (exception is ExternalPartException || exception.IsFileError())
        {
            return $"{exception.Message} The next run looks at all pixels of {ProductId} again.";
        }
    }

    /// <summary>Whether what was found by looking at all pixels is kept for other runs; fewer are looked at in some 0.1 s.</summary>
    public bool IsLarge => _content.IsLarge;

    /// <summary>The file in which that is kept; null if there is none that holds.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program; null if there is none.</param>
    public string? FindKept(string? cacheFolder) => _content.Find(this, Kept(cacheFolder));

    /// <summary>Looks at all pixels again, and compares what is found with the files in which it is kept.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program; null if there is none.</param>
    /// <returns>The first file; null if there is none that holds.</returns>
    /// <exception cref="BadInputException">They differ.</exception>
    public string? VerifyKept(string? cacheFolder, CancellationToken cancellation) =>
        _content.Verify(this, Kept(cacheFolder), cancellation);

    private byte[] Fingerprint() => RasterScanFile.Fingerprint(Files, Invariant($"{_placement} {_rule}"));

    private KeptRaster Kept(string? cacheFolder)
    {
        LdemSet set = LdemSet.OfMap(ToLabel());
        return new KeptRaster(
            set.PlacesOf(RasterScanFile.Extension, cacheFolder), set.PlacesOf(PyramidFile.Extension, cacheFolder), Fingerprint());
    }

    /// <summary>The model of the whole Moon that it is; null for a map of a part, or one with places without data.</summary>
    public WholeGrid? AsWholeMoon() => CoversWholeMoon && !MayHaveGaps ? new WholeGrid(this) : null;

    /// <summary>Whether it has a sample for each place of the Moon, be it without data.</summary>
    public bool CoversWholeMoon => _placement.IsRing && (Window.FirstLine, Window.EndLine) == (0, Lines);

    /// <summary>The file as the label of a model, for its name, fingerprint and checksum.</summary>
    public LdemLabel ToLabel() => new(
        _path, _path, ImageOffset: 0, ProductId, CelestialBody.Moon, Projection.Resolution.PixelsPerDegree ?? 0, _content.Blocks.Height,
        _content.Blocks.Width, LdemSampleType.Float32LittleEndian, ScalingFactor: 1.0, SphereRadius, _rule.Lowest,
        _rule.Highest, Polar: Projection as PolarStereographic)
    { OtherFiles = [.. Files.Skip(1)] };

    /// <inheritdoc/>
    public bool MayHaveGaps => _content.Scan().HasGaps;

    /// <inheritdoc/>
    public IReadOnlyList<ITerrainGrid> StoredLevels => _content.Levels;

    /// <inheritdoc/>
    public bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) =>
        _content.Scan().HasGaps && SquaresOf(firstLine, lines, firstSample, samples).Gaps > 0;

    /// <inheritdoc/>
    public KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples)
    {
        ScannedSquare all = SquaresOf(firstLine, lines, firstSample, samples);
        return all.Min > all.Max ? null : new KnownBounds(
            _placement.SphereRadius + _rule.HeightOf(all.Min), _placement.SphereRadius + _rule.HeightOf(all.Max), _rule.Factor * all.Step);
    }

    /// <inheritdoc/>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        RasterScan scan = _content.Scan();
        int row = RowOf(line);
        for (int i = 0; i < isGap.Length;)
        {
            int column = ColumnOf(firstSample + i);
            int count = _content.Blocks.RunLength(column, isGap.Length - i);
            Span<bool> part = isGap.Slice(i, count);
            part.Clear();
            if (scan.Of(row, 1, column, count).Gaps > 0)
            {
                ReadOnlySpan<float> values = RunAt(row, column, count);
                count = values.Length;
                for (int j = 0; j < count; j++)
                {
                    part[j] = float.IsNaN(values[j]);
                }
            }

            i += count;
        }
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        int row = RowOf(line);
        for (int i = 0; i < radii.Length;)
        {
            int column = ColumnOf(firstSample + i);
            ReadOnlySpan<float> values = RunAt(row, column, radii.Length - i);
            for (int j = 0; j < values.Length; j++)
            {
                radii[i + j] = float.IsNaN(values[j])
                    ? throw Hole(row, column + j)
                    : _placement.SphereRadius + _rule.HeightOf(values[j]);
            }

            i += values.Length;
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose() => _content.Dispose();

    private ReadOnlySpan<float> RunAt(int row, int column, int most) =>
        _content.Known is { } scan && scan.Border.RunAt(row, column, most) is { IsEmpty: false } run
            ? run
            : _content.Blocks.RunAt(row, column, most);

    /// <summary>What the pixels of a rectangle are; of a map that goes all around also across the grid's last sample.</summary>
    private ScannedSquare SquaresOf(int firstLine, int lines, int firstSample, int samples)
    {
        (int row, int column) = (firstLine - Window.FirstLine, ColumnOf(firstSample));
        int before = Math.Min(samples, _content.Blocks.Width - column);
        ScannedSquare all = _content.Scan().Of(row, lines, column, before);
        return before == samples ? all : all.With(_content.Scan().Of(row, lines, 0, samples - before));
    }

    private int RowOf(int line)
    {
        int row = line - Window.FirstLine;
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)row, (uint)_content.Blocks.Height, nameof(line));
        return row;
    }

    private int ColumnOf(int sample)
    {
        int column = sample - Window.FirstSample;
        column -= _placement.IsRing && column >= Samples ? Samples : 0;
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)column, (uint)_content.Blocks.Width, nameof(sample));
        return column;
    }

    private BadInputException Hole(int row, int column) => new(Invariant(
        $"{_path}, line {row + 1}, sample {_placement.ColumnOf(column) + 1}: no data there. Fill the hole, e.g. with gdal_fillnodata.py, "
            + $"cut the file to what is whole, with gdal_translate -srcwin, or put a coarser model around it, with a second --ldem."));
}
