using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

internal static partial class CSpiceNative
{
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    internal static partial void deltet_c(double epoch, string epochType, out double deltaSeconds);
}
