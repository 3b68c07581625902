using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>
/// An image that is drawn on with cairo; every result is checked. Coordinates are in px from the upper left corner, x right, y down.
/// </summary>
internal sealed unsafe class CairoImage : IDisposable
{
    /// <summary>
    /// cairo's own built-in vector font: it needs no font file and no fontconfig, so the text looks the same everywhere. A cairo
    /// that did not know the name would take the system's default font.
    /// </summary>
    private const string FontFamily = "@cairo:monospace";

    private readonly CairoSurfaceHandle _surface;
    private readonly CairoContextHandle _context;

    private CairoImage(CairoSurfaceHandle surface)
    {
        _surface = surface;
        Width = CairoNative.cairo_image_surface_get_width(surface);
        Height = CairoNative.cairo_image_surface_get_height(surface);
        _context = CairoNative.cairo_create(surface);
        CairoNative.cairo_select_font_face(_context, FontFamily, slant: 0, weight: 0);
        ThrowIfContextFailed("cairo_create");
    }

    /// <summary>px.</summary>
    public int Width { get; }

    /// <summary>px.</summary>
    public int Height { get; }

    /// <summary>Begins a black image.</summary>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <exception cref="ExternalPartException">cairo is missing or has too little memory.</exception>
    public static CairoImage Black(int width, int height)
    {
        RequireLibrary(CairoNative.Library);
        CairoSurfaceHandle surface = CairoNative.cairo_image_surface_create(CairoNative.FormatArgb32, width, height);
        ThrowIfFailed(CairoNative.cairo_surface_status(surface), "cairo_image_surface_create");
        CairoImage image = new(surface);
        image.SetColor(0.0, 0.0, 0.0, 1.0);
        image.FillRectangle(0.0, 0.0, width, height);
        return image;
    }

    /// <summary>Reads a PNG image.</summary>
    /// <exception cref="ExternalPartException">cairo is missing.</exception>
    /// <exception cref="BadInputException">The stream does not hold a whole PNG image.</exception>
    public static CairoImage FromPng(Stream png)
    {
        RequireLibrary(CairoNative.Library);
        using CairoStream source = new(png);
        CairoSurfaceHandle surface = CairoNative.cairo_image_surface_create_from_png_stream(CairoStream.ReadCallback, source.Closure);
        int status = CairoNative.cairo_surface_status(surface);
        if (status == CairoNative.StatusSuccess)
        {
            return new CairoImage(surface);
        }

        surface.Dispose();
        source.ThrowIfFailed();
        if (status == CairoNative.StatusNoMemory)
        {
            throw new ExternalPartException(
                "cairo has too little memory for the image. Make the image smaller or leave out the annotation.");
        }

        throw new BadInputException($"The image can't be read as PNG: {Text(status)}.");
    }

    /// <summary>Checks that a library can be loaded.</summary>
    /// <param name="name">As the run-time linker knows it.</param>
    /// <exception cref="ExternalPartException">It can't.</exception>
    public static void RequireLibrary(string name)
    {
        if (!NativeLibrary.TryLoad(name, typeof(CairoImage).Assembly, searchPath: null, out _))
        {
            throw new ExternalPartException(
                $"{name} (cairo, which draws on images) can't be loaded. Install it (Debian, Ubuntu: "
                    + $"apt-get install libcairo2) or leave out --rendering-annotation and --contact-sheet.");
        }
    }

    /// <summary>Writes the image as PNG; equal images give equal bytes.</summary>
    public void WritePng(Stream png)
    {
        using CairoStream destination = new(png);
        int status = CairoNative.cairo_surface_write_to_png_stream(_surface, CairoStream.WriteCallback, destination.Closure);
        destination.ThrowIfFailed();
        ThrowIfFailed(status, "cairo_surface_write_to_png_stream");
    }

    /// <summary>Sets the colour of what is drawn next; parts from 0 to 1.</summary>
    public void SetColor(double red, double green, double blue, double alpha) =>
        CairoNative.cairo_set_source_rgba(_context, red, green, blue, alpha);

    public void DrawLine(double x1, double y1, double x2, double y2, double width)
    {
        CairoNative.cairo_set_line_width(_context, width);
        CairoNative.cairo_move_to(_context, x1, y1);
        CairoNative.cairo_line_to(_context, x2, y2);
        CairoNative.cairo_stroke(_context);
        ThrowIfContextFailed("cairo_stroke");
    }

    /// <summary>Draws a filled circle.</summary>
    public void FillCircle(double x, double y, double radius)
    {
        CairoNative.cairo_arc(_context, x, y, radius, 0.0, 2.0 * Math.PI);
        CairoNative.cairo_fill(_context);
        ThrowIfContextFailed("cairo_fill");
    }

    /// <summary>Draws a filled rectangle.</summary>
    public void FillRectangle(double x, double y, double width, double height)
    {
        CairoNative.cairo_rectangle(_context, x, y, width, height);
        CairoNative.cairo_fill(_context);
        ThrowIfContextFailed("cairo_fill");
    }

    /// <summary>Draws another image with its upper left corner at a point.</summary>
    public void DrawImage(CairoImage other, double x, double y, double scale)
    {
        CairoNative.cairo_save(_context);
        CairoNative.cairo_translate(_context, x, y);
        CairoNative.cairo_scale(_context, scale, scale);
        CairoNative.cairo_set_source_surface(_context, other._surface, 0.0, 0.0);
        CairoNative.cairo_paint(_context);
        CairoNative.cairo_restore(_context);
        ThrowIfContextFailed("cairo_paint");
    }

    /// <summary>How far a text reaches to the right, px.</summary>
    public double MeasureText(string text, double fontSize)
    {
        CairoNative.cairo_set_font_size(_context, fontSize);
        CairoNative.cairo_text_extents(_context, text, out CairoTextExtents extents);
        ThrowIfContextFailed("cairo_text_extents");
        return extents.AdvanceX;
    }

    /// <summary>Draws a text whose base line starts at a point.</summary>
    public void DrawText(string text, double x, double y, double fontSize)
    {
        CairoNative.cairo_set_font_size(_context, fontSize);
        CairoNative.cairo_move_to(_context, x, y);
        CairoNative.cairo_show_text(_context, text);
        ThrowIfContextFailed("cairo_show_text");
    }

    public void Dispose()
    {
        _context.Dispose();
        _surface.Dispose();
    }

    private static string Text(int status) => Marshal.PtrToStringUTF8(CairoNative.cairo_status_to_string(status)) ?? string.Empty;

    private static void ThrowIfFailed(int status, string function)
    {
        if (status != CairoNative.StatusSuccess)
        {
            throw new ExternalPartException($"{function}: {Text(status)}.");
        }
    }

    private void ThrowIfContextFailed(string function) => ThrowIfFailed(CairoNative.cairo_status(_context), function);
}
