using System.Runtime.InteropServices;
using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>An image that GDAL reads; its first band counts. Not safe for several threads, unless <see cref="IsMapped"/>.</summary>
internal sealed unsafe class GdalImage : IDisposable
{
    /// <summary>
    /// Arguments of gdalwarp for floats, bilinear between pixels. The scales: always between four pixels, as GDAL otherwise takes the mean
    /// of more where its pixels are a little larger.
    /// </summary>
    private static readonly string[] Bilinear =
        ["-of", "VRT", "-ot", "Float32", "-r", "bilinear", "-wo", "XSCALE=1", "-wo", "YSCALE=1", "-et", "0", "-dstnodata", "nan"];

    /// <summary>Ends of the names of files that hold nothing but statistics and coarser levels.</summary>
    private static readonly string[] Derived = [".aux.xml", ".ovr"];

    private const string RemoteAdvice =
        "It needs a network, and a server that sends parts of files, and at least 1000 bytes in a second: check the address, try again, "
        + "or get the whole file and name it here.";

    private readonly GdalNative _gdal;
    private readonly string _path;
    private readonly nint _band;
    private readonly GdalImage? _source;
    private readonly SpecialValues _special;
    private readonly GdalMapping? _mapping;
    private nint _image;

    private GdalImage(GdalNative gdal, string path, nint image, GdalImage? source = null)
    {
        _gdal = gdal;
        _path = path;
        _image = image;
        _source = source;
        Width = gdal.GDALGetRasterXSize(image);
        Height = gdal.GDALGetRasterYSize(image);
        _band = gdal.GDALGetRasterBand(image, 1);
        int type = gdal.GDALGetRasterDataType(_band);
        IsBytes = type == GdalNative.TypeByte;
        IsComplex = type is >= GdalNative.FirstComplexType and <= GdalNative.LastComplexType;
        int across = 0;
        int down = 0;
        gdal.GDALGetBlockSize(_band, &across, &down);
        int isThere = 0;
        double value = gdal.GDALGetRasterNoDataValue(_band, &isThere);
        NoData = isThere != 0 ? value : null;
        _special = SpecialValues.Of(Driver, type, Metadata(gdal, image, "xml:PDS4"));
        _mapping = source is null && !IsRemote(path) ? GdalMapping.Of(gdal, _band, type) : null;
        HasWideBlocks = _mapping is null && across > Width / 2;
    }

    /// <summary>Pixels of a row.</summary>
    public int Width { get; }

    /// <summary>Number of rows.</summary>
    public int Height { get; }

    /// <summary>The values are whole numbers from 0 to 255.</summary>
    public bool IsBytes { get; }

    /// <summary>The file is stored in blocks as wide as the image, as rows are: a part of a row costs as much as all of it.</summary>
    public bool HasWideBlocks { get; }

    /// <summary>The pixels are mapped into memory: several threads may read them at once.</summary>
    public bool IsMapped => _mapping is not null;

    /// <summary>The values are complex numbers.</summary>
    public bool IsComplex { get; }

    /// <summary>The value of pixels without data; null if there is none.</summary>
    public double? NoData { get; }

    /// <summary>Whether the file, or its format, says which values are of pixels without data.</summary>
    public bool DeclaresGaps => NoData is not null || _special.Any;

    /// <summary>Short name of GDAL's driver, e.g. "GTiff".</summary>
    public string Driver => _gdal.GDALGetDatasetDriver(_image) is not 0 and nint driver
        ? Marshal.PtrToStringUTF8((nint)_gdal.GDALGetDriverShortName(driver)) ?? string.Empty
        : string.Empty;

    /// <summary>Number of bands.</summary>
    public int Bands => _gdal.GDALGetRasterCount(_image);

    /// <summary>Opens an image.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL is missing.</exception>
    /// <exception cref="BadInputException">GDAL can't read the file.</exception>
    /// <param name="advice">What to give instead of a file that is none.</param>
    public static GdalImage Open(string path, string? libraryPath, string advice = "Give a PDS3, TIFF, JPEG or PNG image.")
    {
        GdalNative gdal = GdalLibrary.Require(libraryPath, $"{Path.GetFileName(path)}, which is not a PDS3 image,");
        nint opened;
        gdal.CPLErrorReset();
        fixed (byte* name = Encoding.UTF8.GetBytes(path + '\0'))
        {
            opened = gdal.GDALOpenEx(name, GdalNative.OpenRaster, 0, 0, 0);
        }

        if (opened == 0 || gdal.GDALGetRasterBand(opened, 1) == 0)
        {
            throw new BadInputException(IsRemote(path)
                ? $"{path}: GDAL can't open the remote file ({Message(gdal)}). {RemoteAdvice}"
                : $"{path}: GDAL can't read it as an image ({Message(gdal)}). {advice}");
        }

        GdalImage image = new(gdal, path, opened);
        if (IsRemote(path) && image.IsHeadBroken())
        {
            string reason = Message(gdal);
            image.Dispose();
            throw new BadInputException($"{path}: the head of the remote file is not whole ({reason}). {RemoteAdvice}");
        }

        return image;
    }

    /// <summary>
    /// Whether a part of a remote file's head did not come: GDAL takes that for missing, with a warning, and would give an image without
    /// a coordinate system, or without the value for no data.
    /// </summary>
    private bool IsHeadBroken()
    {
        bool isPlaced = (Projection(), GeoTransform()) is (not null, not null);
        int error = _gdal.CPLGetLastErrorType();
        return error >= GdalNative.Failure || (error == GdalNative.Warning
            && (!isPlaced || Message(_gdal).Contains("IO error", StringComparison.Ordinal)));
    }

    /// <summary>The files of which the image is made, but for what GDAL's tools keep beside it; the image's own path first.</summary>
    public IReadOnlyList<string> Files()
    {
        byte** list = _gdal.GDALGetFileList(_image);
        List<string> files = [_path];
        for (byte** file = list; file is not null && *file is not null; file++)
        {
            string name = Marshal.PtrToStringUTF8((nint)(*file))!;
            if (!Array.Exists(Derived, end => name.EndsWith(end, StringComparison.OrdinalIgnoreCase))
                && !files.Exists(known => Path.GetFullPath(known) == Path.GetFullPath(name)))
            {
                files.Add(name);
            }
        }

        _gdal.CSLDestroy(list);
        return files;
    }

    /// <summary>The six numbers that give map coordinates of a pixel; null if the image has none.</summary>
    public double[]? GeoTransform()
    {
        double[] numbers = new double[6];
        fixed (double* start = numbers)
        {
            return _gdal.GDALGetGeoTransform(_image, start) < GdalNative.Failure ? numbers : null;
        }
    }

    /// <summary>Unit of the values as the file names it; empty if it names none.</summary>
    public string Unit => _source?.Unit ?? Marshal.PtrToStringUTF8((nint)_gdal.GDALGetRasterUnitType(_band)) ?? string.Empty;

    /// <summary>Factor and offset by which a stored number is a value: 1 and 0 if the file has none.</summary>
    public (double Factor, double Offset) Scale
    {
        get
        {
            if (_source is not null)
            {
                return _source.Scale;
            }

            int isThere = 0;
            double factor = _gdal.GDALGetRasterScale(_band, &isThere);
            factor = isThere != 0 ? factor : 1.0;
            double offset = _gdal.GDALGetRasterOffset(_band, &isThere);
            return (factor, isThere != 0 ? offset : 0.0);
        }
    }

    /// <summary>The map projection as PROJ writes it, e.g. "+proj=stere +lat_0=-90 ..."; null if the file has none.</summary>
    public string? Projection() => GdalProjection.TextOf(_gdal, _image);

    /// <summary>The way from one coordinate system to another.</summary>
    /// <param name="from">In PROJ's form.</param>
    /// <param name="to">In PROJ's form.</param>
    /// <returns>Null if PROJ knows no way.</returns>
    public GdalTransformation? Transformation(string from, string to) => GdalTransformation.Of(_gdal, from, to);

    /// <summary>Whether the file stores nothing for a rectangle, as a sparse one may.</summary>
    /// <param name="line">Top row, from 0.</param>
    /// <param name="lines">How many rows.</param>
    /// <param name="sample">Leftmost pixel, from 0.</param>
    /// <param name="samples">How many pixels of a row.</param>
    public bool IsEmpty(int line, int lines, int sample, int samples) => _mapping is null && _gdal.GDALGetDataCoverageStatus(
        _band, sample, line, samples, lines, GdalNative.CoverageData, null) == GdalNative.CoverageEmpty;

    private static string Metadata(GdalNative gdal, nint image, string domain)
    {
        fixed (byte* name = Encoding.UTF8.GetBytes(domain + '\0'))
        {
            byte** list = gdal.GDALGetMetadata(image, name);
            return list is null || *list is null ? string.Empty : Marshal.PtrToStringUTF8((nint)(*list)) ?? string.Empty;
        }
    }

    /// <summary>The image in another projection, bilinear between pixels, computed where it is read.</summary>
    /// <param name="words">Further arguments of gdalwarp.</param>
    /// <returns>The image, to be closed before this one; null if GDAL can't bring it there.</returns>
    public GdalImage? Warped(params IEnumerable<string> words)
    {
        nint[] texts = [.. ((string[])[.. Bilinear, .. words]).Select(Marshal.StringToCoTaskMemUTF8), 0];
        nint options;
        fixed (nint* start = texts)
        {
            options = _gdal.GDALWarpAppOptionsNew((byte**)start, 0);
        }

        Array.ForEach(texts, Marshal.FreeCoTaskMem);
        if (options == 0)
        {
            return null;
        }

        nint source = _image;
        byte nameless = 0;
        nint warped = _gdal.GDALWarp(&nameless, 0, 1, &source, options, null);
        _gdal.GDALWarpAppOptionsFree(options);
        return warped == 0 ? null : new GdalImage(_gdal, _path, warped, this);
    }

    /// <summary>Reads a rectangle.</summary>
    /// <param name="line">Top row, from 0.</param>
    /// <param name="lines">How many rows.</param>
    /// <param name="sample">Leftmost pixel, from 0.</param>
    /// <param name="samples">How many pixels of a row.</param>
    /// <param name="values">Receives them, row by row; NaN where there is no data.</param>
    /// <param name="stride">Values from one row to the next; 0 if none lie between.</param>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public void Read(int line, int lines, int sample, int samples, Span<float> values, int stride = 0)
    {
        stride = stride == 0 ? samples : stride;
        ArgumentOutOfRangeException.ThrowIfLessThan(values.Length, ((lines - 1) * stride) + samples);
        ReadStored(line, lines, sample, samples, values, stride);
        for (int i = 0; NoData is double noData && i < lines; i++)
        {
            values.Slice(i * stride, samples).Replace((float)noData, float.NaN);
        }

        for (int i = 0; _special.Any && i < lines; i++)
        {
            _special.Remove(values.Slice(i * stride, samples));
        }
    }

    private void ReadStored(int line, int lines, int sample, int samples, Span<float> values, int stride)
    {
        if (_mapping is not null)
        {
            for (int i = 0; i < lines; i++)
            {
                _mapping.Read(line + i, sample, values.Slice(i * stride, samples));
            }

            return;
        }

        fixed (float* start = values)
        {
            Require(_gdal.GDALRasterIO(
                _band, 0, sample, line, samples, lines, start, samples, lines, GdalNative.TypeFloat32, 0, stride * sizeof(float)));
        }
    }

    private void Require(int result)
    {
        if (result >= GdalNative.Failure)
        {
            throw new BadInputException($"{_path}: GDAL can't read it to its end ({Message(_gdal)}). "
                + (IsRemote(_path) ? $"The remote file broke off. {RemoteAdvice}" : "Get the file again."));
        }
    }

    /// <summary>Closes the image.</summary>
    public void Dispose()
    {
        if (Interlocked.Exchange(ref _image, 0) is not 0 and nint image)
        {
            _mapping?.Dispose();
            _gdal.GDALClose(image);
        }
    }

    private static bool IsRemote(string path) => path.Contains("://", StringComparison.Ordinal);

    private static string Message(GdalNative gdal) => Marshal.PtrToStringUTF8((nint)gdal.CPLGetLastErrorMsg()) is { Length: > 0 } text
        ? text.ReplaceLineEndings(" ")
        : "no reason given";
}
