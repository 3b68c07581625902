using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>The way from one coordinate system to another, by PROJ. Not safe for several threads.</summary>
internal sealed unsafe class GdalTransformation : IDisposable
{
    private readonly GdalNative _gdal;
    private nint _handle;

    private GdalTransformation(GdalNative gdal, nint handle) => (_gdal, _handle) = (gdal, handle);

    /// <summary>Finds the way.</summary>
    /// <param name="from">In PROJ's form, e.g. "+proj=longlat +R=1737400".</param>
    /// <param name="to">In PROJ's form.</param>
    /// <returns>Null if PROJ knows none.</returns>
    public static GdalTransformation? Of(GdalNative gdal, string from, string to)
    {
        (nint source, nint target) = (Reference(gdal, from), Reference(gdal, to));
        nint handle = source == 0 || target == 0 ? 0 : gdal.OCTNewCoordinateTransformation(source, target);
        foreach (nint reference in (ReadOnlySpan<nint>)[source, target])
        {
            if (reference != 0)
            {
                gdal.OSRDestroySpatialReference(reference);
            }
        }

        return handle == 0 ? null : new GdalTransformation(gdal, handle);
    }

    /// <summary>Brings points from one system to the other, in place; those that have no place there become NaN.</summary>
    /// <param name="x">Degrees of longitude, or map coordinates to the east.</param>
    /// <param name="y">Degrees of latitude, or map coordinates to the north; as many.</param>
    public void Transform(Span<double> x, Span<double> y)
    {
        int[] isThere = new int[x.Length];
        fixed (double* across = x, up = y)
        {
            fixed (int* success = isThere)
            {
                _ = _gdal.OCTTransformEx(_handle, x.Length, across, up, null, success);
            }
        }

        for (int i = 0; i < x.Length; i++)
        {
            if (isThere[i] == 0 || !double.IsFinite(x[i]) || !double.IsFinite(y[i]))
            {
                (x[i], y[i]) = (double.NaN, double.NaN);
            }
        }
    }

    /// <summary>Frees it.</summary>
    public void Dispose()
    {
        if (Interlocked.Exchange(ref _handle, 0) is not 0 and nint handle)
        {
            _gdal.OCTDestroyCoordinateTransformation(handle);
        }
    }

    private static nint Reference(GdalNative gdal, string text)
    {
        nint reference = gdal.OSRNewSpatialReference(null);
        fixed (byte* words = Encoding.UTF8.GetBytes(text + '\0'))
        {
            if (gdal.OSRImportFromProj4(reference, words) != GdalNative.NoError)
            {
                gdal.OSRDestroySpatialReference(reference);
                return 0;
            }
        }

        gdal.OSRSetAxisMappingStrategy(reference, GdalNative.LongitudeFirst);
        return reference;
    }
}
