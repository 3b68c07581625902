using Msisf.Adapters.Drawing;
using SkiaSharp;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// A map in a JPEG image without map coordinates, decoded as libjpeg does. The red channel of a colour image counts. Rows are decoded from
/// north to south; a row above the last one starts again at the top.
/// </summary>
internal sealed class JpegMapSource : MapSource
{
    /// <summary>Endings of files beside an image that place it on a map.</summary>
    private static readonly string[] PlacedBy = [".wld", ".jgw", ".jpw", ".jpgw", ".jpegw", ".tab", ".points"];

    private readonly string _path;
    private readonly SKCodec _codec;
    private readonly SKImageInfo _format;
    private byte[] _rows = [];
    private int _next = int.MaxValue;

    private JpegMapSource(string path, SKCodec codec)
        : base(codec.Info.Width, codec.Info.Height, extent: null, isBytes: true)
    {
        _path = path;
        _codec = codec;

        // Without a colour space: the numbers as they are stored.
        _format = new SKImageInfo(codec.Info.Width, codec.Info.Height, SKColorType.Rgba8888, SKAlphaType.Opaque);
    }

    /// <summary>Opens a JPEG image; null for any other file, and for an image that GDAL can place on the Moon.</summary>
    /// <exception cref="BadInputException">The file can't be read.</exception>
    /// <exception cref="ExternalPartException">Skia is missing.</exception>
    public static JpegMapSource? TryOpen(string path)
    {
        bool isJpeg = FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            return (stream.ReadByte(), stream.ReadByte(), stream.ReadByte()) == (0xFF, 0xD8, 0xFF);
        });
        if (!isJpeg || PlacedBy.Any(ending => File.Exists(Path.ChangeExtension(path, ending))) || File.Exists($"{path}.aux.xml"))
        {
            return null;
        }

        SKCodec codec = Skia.Guarded(() => SKCodec.Create(path)) ?? throw Damaged(path, row: 0);
        return new JpegMapSource(path, codec);
    }

    /// <inheritdoc/>
    public override unsafe void Read(int first, int count, Span<float> values)
    {
        if (first < _next)
        {
            if (_codec.StartScanlineDecode(_format) != SKCodecResult.Success)
            {
                throw Damaged(_path, row: 0);
            }

            _next = 0;
        }

        if (first > _next && !_codec.SkipScanlines(first - _next))
        {
            throw Damaged(_path, _next);
        }

        _next = first + count;
        Array.Resize(ref _rows, Math.Max(_rows.Length, count * _format.RowBytes));
        int read;
        fixed (byte* rows = _rows)
        {
            read = _codec.GetScanlines((nint)rows, count, _format.RowBytes);
        }

        if (read < count)
        {
            throw Damaged(_path, first + Math.Max(read, 0));
        }

        for (int i = 0; i < count * Width; i++)
        {
            values[i] = _rows[_format.BytesPerPixel * i];
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _codec.Dispose();

    private static BadInputException Damaged(string path, int row) => new(
        $"{path}: the JPEG image is damaged or cut off at row {row + 1}. Get the file again.");
}
