using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>The functions of CSPICE: C names, no logic. Only <see cref="CSpice"/> calls them, under its lock.</summary>
internal static partial class CSpiceNative
{
    /// <summary>The name that <see cref="CSpiceLibrary"/> resolves.</summary>
    internal const string Library = "cspice";

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void erract_c(string operation, int actionLength, string action);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void errprt_c(string operation, int listLength, string list);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial int failed_c();

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void getmsg_c(string option, int messageLength, ref byte message);

    [LibraryImport(Library)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void reset_c();

    /// <summary>Returns static text that is not to be freed.</summary>
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial nint tkvrsn_c(string item);
}
