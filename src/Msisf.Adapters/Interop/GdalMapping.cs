using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Adapters.Interop;

/// <summary>
/// An image's pixels as they lie in its file, mapped into memory: an uncompressed image of a local file, stored row after row in the
/// processor's byte order. Parts of its rows cost what they hold, as they do in a PDS3 image.
/// </summary>
internal sealed unsafe class GdalMapping : IDisposable
{
    private readonly GdalNative _gdal;
    private readonly bool _isFloat;
    private readonly byte* _first;
    private readonly long _rowBytes;
    private nint _memory;

    private GdalMapping(GdalNative gdal, nint memory, bool isFloat, long rowBytes)
    {
        (_gdal, _memory, _isFloat, _rowBytes) = (gdal, memory, isFloat, rowBytes);
        _first = gdal.CPLVirtualMemGetAddr(memory);
    }

    /// <summary>Maps a band of 16-bit integers or floats.</summary>
    /// <param name="band">Band of an open image, which is closed after this.</param>
    /// <param name="type">GDAL's number of the type of its values.</param>
    /// <returns>Null if its pixels don't lie in a file like that.</returns>
    public static GdalMapping? Of(GdalNative gdal, nint band, int type)
    {
        int size = type == GdalNative.TypeInt16 ? sizeof(short) : sizeof(float);
        if (type is not (GdalNative.TypeInt16 or GdalNative.TypeFloat32))
        {
            return null;
        }

        int pixelBytes = 0;
        long rowBytes = 0;
        nint memory;
        fixed (byte* onlyOfFiles = "USE_DEFAULT_IMPLEMENTATION=NO\0"u8)
        {
            byte** options = stackalloc byte*[] { onlyOfFiles, null };
            memory = gdal.GDALGetVirtualMemAuto(band, GdalNative.ToRead, &pixelBytes, &rowBytes, options);
        }

        if (memory != 0 && pixelBytes != size)
        {
            gdal.CPLVirtualMemFree(memory);
            return null;
        }

        return memory == 0 ? null : new GdalMapping(gdal, memory, type == GdalNative.TypeFloat32, rowBytes);
    }

    /// <summary>Reads a part of a row.</summary>
    /// <param name="line">Line of the image, counted from 0.</param>
    /// <param name="sample">The first pixel.</param>
    /// <param name="values">Receives the stored values.</param>
    public void Read(int line, int sample, Span<float> values)
    {
        byte* row = _first + (line * _rowBytes);
        if (_isFloat)
        {
            new ReadOnlySpan<byte>(row + ((long)sample * sizeof(float)), values.Length * sizeof(float))
                .CopyTo(MemoryMarshal.AsBytes(values));
            return;
        }

        ReadOnlySpan<short> stored = new(row + ((long)sample * sizeof(short)), values.Length);
        int i = 0;
        for (; i <= stored.Length - Vector128<short>.Count; i += Vector128<short>.Count)
        {
            (Vector128<int> low, Vector128<int> high) = Vector128.Widen(Vector128.Create(stored[i..]));
            Vector128.ConvertToSingle(low).CopyTo(values[i..]);
            Vector128.ConvertToSingle(high).CopyTo(values[(i + Vector128<int>.Count)..]);
        }

        for (; i < stored.Length; i++)
        {
            values[i] = stored[i];
        }
    }

    /// <summary>Unmaps the file.</summary>
    public void Dispose()
    {
        if (Interlocked.Exchange(ref _memory, 0) is not 0 and nint memory)
        {
            _gdal.CPLVirtualMemFree(memory);
        }
    }
}
