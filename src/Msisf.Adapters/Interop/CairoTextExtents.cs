using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>cairo_text_extents_t, px: where a text's ink lies relative to its start, and where the next text starts.</summary>
[StructLayout(LayoutKind.Sequential)]
internal readonly record struct CairoTextExtents(
    double BearingX, double BearingY, double Width, double Height, double AdvanceX, double AdvanceY);
