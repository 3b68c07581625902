using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace Msisf.Adapters.Interop;

/// <summary>The functions of cairo 1.10 or newer that annotation and contact sheet need; C names, no logic.</summary>
internal static unsafe partial class CairoNative
{
    /// <summary>The name that the run-time linker knows; Debian and Ubuntu have it in the package libcairo2.</summary>
    internal const string Library = "libcairo.so.2";

    internal const int FormatArgb32 = 0;
    internal const int StatusSuccess = 0;
    internal const int StatusNoMemory = 1;
    internal const int StatusReadError = 10;
    internal const int StatusWriteError = 11;

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial CairoSurfaceHandle cairo_image_surface_create_from_png_stream(
        delegate* unmanaged[Cdecl]<nint, byte*, uint, int> read, nint closure);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int cairo_surface_write_to_png_stream(
        CairoSurfaceHandle surface, delegate* unmanaged[Cdecl]<nint, byte*, uint, int> write, nint closure);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int cairo_surface_status(CairoSurfaceHandle surface);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_surface_destroy(nint surface);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int cairo_image_surface_get_width(CairoSurfaceHandle surface);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int cairo_image_surface_get_height(CairoSurfaceHandle surface);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial CairoContextHandle cairo_create(CairoSurfaceHandle surface);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int cairo_status(CairoContextHandle context);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_destroy(nint context);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_set_source_rgba(CairoContextHandle context, double red, double green, double blue, double alpha);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_set_line_width(CairoContextHandle context, double width);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_move_to(CairoContextHandle context, double x, double y);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_line_to(CairoContextHandle context, double x, double y);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_arc(
        CairoContextHandle context, double x, double y, double radius, double firstAngle, double lastAngle);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_rectangle(CairoContextHandle context, double x, double y, double width, double height);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_stroke(CairoContextHandle context);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_fill(CairoContextHandle context);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_select_font_face(CairoContextHandle context, string family, int slant, int weight);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_set_font_size(CairoContextHandle context, double size);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_text_extents(CairoContextHandle context, string text, out CairoTextExtents extents);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_show_text(CairoContextHandle context, string text);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial nint cairo_status_to_string(int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial CairoSurfaceHandle cairo_image_surface_create(int format, int width, int height);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_save(CairoContextHandle context);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_restore(CairoContextHandle context);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_translate(CairoContextHandle context, double x, double y);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_scale(CairoContextHandle context, double x, double y);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_set_source_surface(CairoContextHandle context, CairoSurfaceHandle surface, double x, double y);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void cairo_paint(CairoContextHandle context);
}

/// <summary>cairo_text_extents_t, px: where a text's ink lies relative to its start, and where the next text starts.</summary>
[StructLayout(LayoutKind.Sequential)]
internal readonly record struct CairoTextExtents(
    double BearingX, double BearingY, double Width, double Height, double AdvanceX, double AdvanceY);

/// <summary>Owns a cairo_surface_t.</summary>
internal sealed class CairoSurfaceHandle() : SafeHandleZeroOrMinusOneIsInvalid(ownsHandle: true)
{
    protected override bool ReleaseHandle()
    {
        CairoNative.cairo_surface_destroy(handle);
        return true;
    }
}

/// <summary>Owns a cairo_t.</summary>
internal sealed class CairoContextHandle() : SafeHandleZeroOrMinusOneIsInvalid(ownsHandle: true)
{
    protected override bool ReleaseHandle()
    {
        CairoNative.cairo_destroy(handle);
        return true;
    }
}
