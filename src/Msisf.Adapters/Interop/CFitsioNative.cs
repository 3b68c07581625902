using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace Msisf.Adapters.Interop;

/// <summary>
/// The functions of CFITSIO 4 that the layers need; C names, no logic. A status that is not 0 on entry makes them do nothing.
/// </summary>
internal static unsafe partial class CFitsioNative
{
    /// <summary>The name that the run-time linker knows; Debian and Ubuntu have it in the package libcfitsio10.</summary>
    internal const string Library = "libcfitsio.so.10";

    internal const int TypeByte = 11;
    internal const int TypeUnsignedShort = 20;
    internal const int TypeInt = 31;
    internal const int TypeFloat = 42;
    internal const int TypeDouble = 82;

    /// <summary>Compression GZIP_2: gzip of the bytes sorted by significance.</summary>
    internal const int ShuffledGzip = 22;

    /// <summary>Value of <see cref="fits_set_quantize_level"/> for compression without loss.</summary>
    internal const float NoQuantization = 9999.0f;

    /// <summary>Bytes that <see cref="ffgerr"/> may write.</summary>
    internal const int StatusTextLength = 31;

    /// <summary>Bytes that <see cref="ffgmsg"/> may write.</summary>
    internal const int MessageLength = 81;

    /// <summary>Bytes that <see cref="ffesum"/> writes.</summary>
    internal const int ChecksumLength = 17;

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffimem(
        out CFitsioHandle file,
        void** buffer,
        nuint* size,
        nuint step,
        delegate* unmanaged[Cdecl]<void*, nuint, void*> reallocate,
        ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffdkinit(out CFitsioHandle file, string path, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffclos(nint file, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffflus(CFitsioHandle file, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffcrimll(CFitsioHandle file, int bitsPerPixel, int axes, long* lengths, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffppr(CFitsioHandle file, int type, long first, long count, void* values, ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffpkys(CFitsioHandle file, string key, string value, string? comment, ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffmkys(CFitsioHandle file, string key, string value, string comment, ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffpkls(CFitsioHandle file, string key, string value, string? comment, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffplsw(CFitsioHandle file, ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffpkyj(CFitsioHandle file, string key, long value, string? comment, ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffpkyd(CFitsioHandle file, string key, double value, int decimals, string? comment, ref int status);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffpcom(CFitsioHandle file, string comment, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffgcks(CFitsioHandle file, out nuint dataSum, out nuint unitSum, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void ffesum(nuint sum, int complement, byte* text);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffghadll(CFitsioHandle file, out long headerStart, out long dataStart, out long dataEnd, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void ffgerr(int status, byte* text);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int ffgmsg(byte* text);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int fits_is_reentrant();

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int fits_set_compression_type(CFitsioHandle file, int type, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int fits_set_quantize_level(CFitsioHandle file, float level, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int fits_set_tile_dim(CFitsioHandle file, int axes, long* lengths, ref int status);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int fits_img_compress(CFitsioHandle image, CFitsioHandle compressed, ref int status);
}

/// <summary>Owns a fitsfile.</summary>
internal sealed class CFitsioHandle() : SafeHandleZeroOrMinusOneIsInvalid(ownsHandle: true)
{
    protected override bool ReleaseHandle()
    {
        lock (CFitsio.Gate)
        {
            int status = 0;
            return CFitsioNative.ffclos(handle, ref status) == 0;
        }
    }
}
