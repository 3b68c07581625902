using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

internal static partial class CSpiceNative
{
    /// <param name="target">Name of the body.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <param name="correction">NONE, LT, LT+S, ...</param>
    /// <param name="observer">Name of the body.</param>
    /// <param name="positionKm">First of three elements.</param>
    /// <param name="lightTimeSeconds">One-way light time.</param>
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void spkpos_c(
        string target,
        double ephemerisSeconds,
        string frame,
        string correction,
        string observer,
        ref double positionKm,
        out double lightTimeSeconds);

    /// <param name="from">Name of the source frame.</param>
    /// <param name="to">Name of the target frame.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <param name="rotation">First of nine elements, row by row.</param>
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void pxform_c(string from, string to, double ephemerisSeconds, ref double rotation);

    /// <param name="from">Name of the source frame.</param>
    /// <param name="to">Name of the target frame.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <param name="ofStates">First of 36 elements, row by row.</param>
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void sxform_c(string from, string to, double ephemerisSeconds, ref double ofStates);

    /// <param name="ofStates">First of the 36 elements that <see cref="sxform_c"/> gives.</param>
    /// <param name="rotation">First of nine elements, row by row.</param>
    /// <param name="rate">First of three elements: rad/s of the target frame, along the source frame's axes.</param>
    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void xf2rav_c(in double ofStates, ref double rotation, ref double rate);

    /// <param name="target">NAIF's number of the body.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <param name="observer">NAIF's number of the body.</param>
    /// <param name="state">First of six elements: km, km/s.</param>
    /// <param name="lightTimeSeconds">One-way light time.</param>
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void spkgeo_c(
        int target,
        double ephemerisSeconds,
        string frame,
        int observer,
        ref double state,
        out double lightTimeSeconds);
}
