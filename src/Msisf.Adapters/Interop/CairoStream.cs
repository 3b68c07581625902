using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>
/// Lets cairo's read and write callbacks use a stream. An exception must not pass through native code: it is kept and thrown after the
/// call.
/// </summary>
internal sealed unsafe class CairoStream : IDisposable
{
    private readonly Stream _stream;
    private GCHandle _self;
    private ExceptionDispatchInfo? _failure;

    public CairoStream(Stream stream)
    {
        _stream = stream;
        _self = GCHandle.Alloc(this);
    }

    /// <summary>What the callbacks need to find this object again.</summary>
    public nint Closure => GCHandle.ToIntPtr(_self);

    /// <summary>cairo_read_func_t: fills all the bytes or fails.</summary>
    public static delegate* unmanaged[Cdecl]<nint, byte*, uint, int> ReadCallback => &Read;

    /// <summary>cairo_write_func_t.</summary>
    public static delegate* unmanaged[Cdecl]<nint, byte*, uint, int> WriteCallback => &Write;

    /// <summary>Throws what the stream threw inside a callback.</summary>
    public void ThrowIfFailed() => _failure?.Throw();

    public void Dispose() => _self.Free();

    [UnmanagedCallersOnly(CallConvs = [typeof(CallConvCdecl)])]
    private static int Read(nint closure, byte* data, uint length)
    {
        CairoStream owner = Owner(closure);
        try
        {
            Span<byte> wanted = new(data, checked((int)length));
            bool isWhole = owner._stream.ReadAtLeast(wanted, wanted.Length, throwOnEndOfStream: false) == wanted.Length;
            return isWhole ? CairoNative.StatusSuccess : CairoNative.StatusReadError;
        }
        catch (Exception exception)
        {
            owner._failure = ExceptionDispatchInfo.Capture(exception);
            return CairoNative.StatusReadError;
        }
    }

    [UnmanagedCallersOnly(CallConvs = [typeof(CallConvCdecl)])]
    private static int Write(nint closure, byte* data, uint length)
    {
        CairoStream owner = Owner(closure);
        try
        {
            owner._stream.Write(new ReadOnlySpan<byte>(data, checked((int)length)));
            return CairoNative.StatusSuccess;
        }
        catch (Exception exception)
        {
            owner._failure = ExceptionDispatchInfo.Capture(exception);
            return CairoNative.StatusWriteError;
        }
    }

    private static CairoStream Owner(nint closure) => (CairoStream)GCHandle.FromIntPtr(closure).Target!;
}
