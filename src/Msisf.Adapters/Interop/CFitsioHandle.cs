using Microsoft.Win32.SafeHandles;

namespace Msisf.Adapters.Interop;

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
