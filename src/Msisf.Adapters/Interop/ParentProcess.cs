using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>The program that started this one.</summary>
public static partial class ParentProcess
{
    /// <summary>Its process id, which changes when it dies; always 0 on Windows, where it does not change.</summary>
    public static int Id => OperatingSystem.IsWindows() ? 0 : getppid();

    [LibraryImport("libc")]
    [UnmanagedCallConv(CallConvs = [typeof(System.Runtime.CompilerServices.CallConvCdecl)])]
    private static partial int getppid();
}
