using System.Runtime.InteropServices;
using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>Loads CFITSIO and turns its errors into exceptions.</summary>
internal static unsafe class CFitsio
{
    /// <summary>
    /// The lock for every call: a build that is not reentrant has one state per process, and every build has one list of messages.
    /// </summary>
    public static readonly Lock Gate = new();

    /// <summary>Whether the library may work on several files at the same time.</summary>
    public static bool IsReentrant { get; } = CFitsioNative.fits_is_reentrant() != 0;

    /// <summary>Checks that a library can be loaded.</summary>
    /// <param name="name">As the run-time linker knows it.</param>
    /// <exception cref="ExternalPartException">It can't.</exception>
    public static void RequireLibrary(string name)
    {
        if (!NativeLibrary.TryLoad(name, typeof(CFitsio).Assembly, searchPath: null, out _))
        {
            throw new ExternalPartException(
                $"{name} (CFITSIO, which writes the layers) can't be loaded. Install it (Debian, Ubuntu: "
                    + $"apt-get install libcfitsio10) or give --layers-format npy.");
        }
    }

    /// <summary>Turns a status into an exception; <see cref="Gate"/> is held.</summary>
    /// <param name="status">What the last function left.</param>
    /// <param name="function">Its name.</param>
    /// <exception cref="ExternalPartException">The status is not 0; the text has all that CFITSIO says of it.</exception>
    public static void ThrowIfFailed(int status, string function)
    {
        if (status != 0)
        {
            throw new ExternalPartException(Invariant($"CFITSIO, {function}: {StatusText(status)} (status {status}){TakeMessages()}."));
        }
    }

    private static string StatusText(int status)
    {
        byte* text = stackalloc byte[CFitsioNative.StatusTextLength];
        CFitsioNative.ffgerr(status, text);
        return Marshal.PtrToStringUTF8((nint)text)!;
    }

    private static string TakeMessages()
    {
        StringBuilder messages = new();
        byte* text = stackalloc byte[CFitsioNative.MessageLength];
        while (CFitsioNative.ffgmsg(text) != 0)
        {
            messages.Append("; ").Append(Marshal.PtrToStringUTF8((nint)text)!.Trim());
        }

        return messages.ToString();
    }
}
