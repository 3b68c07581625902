using SkiaSharp;

namespace Msisf.Adapters.Drawing;

/// <summary>
/// An opaque image that is drawn on with Skia. Coordinates are in px from the upper left corner of the image, x right, y down; the centre
/// of the first pixel is at (0.5, 0.5). Text is in DejaVu Sans Mono, which comes with the program: equal drawings give equal bytes.
/// </summary>
internal sealed class Canvas : IDisposable
{
    /// <summary>1: makes a letter half as wide as the font is high, so that the annotation fits on images from 320 px on.</summary>
    private const float Narrowing = 0.83f;

    /// <summary>px.</summary>
    private const double OutlineWidth = 1.0;

    private const double OutlineAlpha = 0.7;

    private static readonly Lazy<SKTypeface> Typeface = new(ReadTypeface);

    private readonly SKBitmap _bitmap;
    private readonly SKCanvas _canvas;
    private readonly SKPaint _paint = new() { IsAntialias = true };
    private readonly SKFont _font = new(Typeface.Value) { Hinting = SKFontHinting.None, Subpixel = true, ScaleX = Narrowing };

    private Canvas(SKBitmap bitmap)
    {
        _bitmap = bitmap;
        _canvas = new SKCanvas(bitmap);
    }

    /// <summary>px.</summary>
    public int Width => _bitmap.Width;

    /// <summary>px.</summary>
    public int Height => _bitmap.Height;

    /// <summary>Begins a black image.</summary>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <exception cref="ExternalPartException">Skia is missing or has too little memory.</exception>
    public static Canvas Black(int width, int height) => Skia.Guarded(() =>
    {
        SKBitmap bitmap = Allocate(FormatOf(width, height));
        bitmap.Erase(SKColors.Black);
        return new Canvas(bitmap);
    });

    /// <summary>Reads a PNG image; 16 bits become 8.</summary>
    /// <exception cref="ExternalPartException">Skia is missing or has too little memory.</exception>
    /// <exception cref="BadInputException">The stream does not hold a whole PNG image.</exception>
    public static Canvas FromPng(Stream png) => Skia.Guarded(() =>
    {
        using MemoryStream bytes = new(); // a stream that fails must not do so inside native code
        png.CopyTo(bytes);
        using SKData data = SKData.CreateCopy(bytes.GetBuffer().AsSpan(0, (int)bytes.Length));
        using SKCodec? codec = SKCodec.Create(data);
        if (codec is not { EncodedFormat: SKEncodedImageFormat.Png })
        {
            throw NotPng(SKCodecResult.InvalidInput);
        }

        SKBitmap bitmap = Allocate(FormatOf(codec.Info.Width, codec.Info.Height));
        SKCodecResult decoded = codec.GetPixels(bitmap.Info, bitmap.GetPixels());
        if (decoded != SKCodecResult.Success)
        {
            bitmap.Dispose();
            throw NotPng(decoded);
        }

        return new Canvas(bitmap);
    });

    /// <summary>Writes the image as PNG; equal images give equal bytes.</summary>
    public void WritePng(Stream png)
    {
        _canvas.Flush();
        using SKPixmap pixels = _bitmap.PeekPixels();
        using SKData data = pixels.Encode(new SKPngEncoderOptions(SKPngEncoderFilterFlags.AllFilters, zLibLevel: 6))
            ?? throw new ExternalPartException("Skia has too little memory to write the image as PNG. Make the image smaller.");
        data.SaveTo(png);
    }

    /// <summary>Sets the colour of what is drawn next; parts from 0 to 1.</summary>
    public void SetColor(double red, double green, double blue, double alpha) =>
        _paint.ColorF = new SKColorF((float)red, (float)green, (float)blue, (float)alpha);

    public void DrawLine(double x1, double y1, double x2, double y2, double width)
    {
        _paint.StrokeWidth = (float)width;
        _canvas.DrawLine((float)x1, (float)y1, (float)x2, (float)y2, _paint);
    }

    /// <summary>Draws something twice, in black and wider, then in a colour: so that it is seen on any ground.</summary>
    /// <param name="color">Parts of red, green and blue, 0 to 1.</param>
    /// <param name="draw">Draws it with so many px more on each side.</param>
    public void DrawOutlined((double Red, double Green, double Blue) color, Action<double> draw)
    {
        SetColor(0.0, 0.0, 0.0, OutlineAlpha);
        draw(OutlineWidth);
        SetColor(color.Red, color.Green, color.Blue, 1.0);
        draw(0.0);
    }

    /// <summary>Draws a filled circle.</summary>
    public void FillCircle(double x, double y, double radius) => _canvas.DrawCircle((float)x, (float)y, (float)radius, _paint);

    /// <summary>Draws a filled rectangle.</summary>
    public void FillRectangle(double x, double y, double width, double height) =>
        _canvas.DrawRect((float)x, (float)y, (float)width, (float)height, _paint);

    /// <summary>Draws another image with its upper left corner at a point.</summary>
    /// <param name="scale">px of this image per px of the other; below 1 each pixel is a mean.</param>
    public void DrawImage(Canvas other, double x, double y, double scale)
    {
        using SKImage image = SKImage.FromBitmap(other._bitmap);
        SKRect place = SKRect.Create((float)x, (float)y, (float)(scale * other.Width), (float)(scale * other.Height));
        _canvas.DrawImage(image, place, new SKSamplingOptions(SKFilterMode.Linear, SKMipmapMode.Linear));
    }

    /// <summary>The distance from the start of a text to the start of one that follows it, px.</summary>
    public double MeasureText(string text, double fontSize) => WithSize(fontSize).MeasureText(text);

    /// <summary>Draws a text whose base line starts at a point.</summary>
    /// <param name="wider">px by which letters are wider on each side.</param>
    public void DrawText(string text, double x, double y, double fontSize, double wider = 0.0)
    {
        (_paint.Style, _paint.StrokeWidth) = (wider > 0.0 ? SKPaintStyle.StrokeAndFill : SKPaintStyle.Fill, (float)(2.0 * wider));
        _canvas.DrawText(text, (float)x, (float)y, WithSize(fontSize), _paint);
        _paint.Style = SKPaintStyle.Fill;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _font.Dispose();
        _paint.Dispose();
        _canvas.Dispose();
        _bitmap.Dispose();
    }

    private static SKImageInfo FormatOf(int width, int height) => new(width, height, SKColorType.Rgba8888, SKAlphaType.Opaque);

    private static SKBitmap Allocate(SKImageInfo format)
    {
        SKBitmap bitmap = new();
        if (!bitmap.TryAllocPixels(format))
        {
            bitmap.Dispose();
            throw new ExternalPartException(
                $"There is too little memory for a drawing of {format.Width} x {format.Height} px. Make the image smaller or leave out "
                    + $"the annotation.");
        }

        return bitmap;
    }

    private static BadInputException NotPng(SKCodecResult result) => new($"The image can't be read as PNG: {result}.");

    private static SKTypeface ReadTypeface()
    {
        using Stream font = typeof(Canvas).Assembly.GetManifestResourceStream("DejaVuSansMono.ttf")
            ?? throw new InvalidOperationException("The font is not in the assembly.");
        return SKTypeface.FromStream(font);
    }

    private SKFont WithSize(double fontSize)
    {
        _font.Size = (float)fontSize;
        return _font;
    }
}
