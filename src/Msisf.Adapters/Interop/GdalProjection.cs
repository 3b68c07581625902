using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>The coordinate system of an image in PROJ's form.</summary>
internal static unsafe class GdalProjection
{
    /// <summary>Relative: units of angles that differ less are the same; labels write them with ten digits and more.</summary>
    private const double SameUnit = 1e-9;

    /// <summary>The map projection as PROJ writes it, e.g. "+proj=stere +lat_0=-90 ..."; null if the file has none.</summary>
    /// <param name="image">GDAL's data set.</param>
    public static string? TextOf(GdalNative gdal, nint image)
    {
        byte* text = gdal.GDALGetProjectionRef(image);
        nint reference = text is null || *text == 0 ? 0 : gdal.OSRNewSpatialReference(text);
        if (reference == 0)
        {
            return null;
        }

        byte* words = null;
        int result = gdal.OSRExportToProj4(reference, &words);
        string? projection = result == GdalNative.NoError ? Marshal.PtrToStringUTF8((nint)words) : null;
        projection = projection is null ? null : projection + WordsThatProj4Lacks(gdal, reference);
        gdal.VSIFree(words);
        gdal.OSRDestroySpatialReference(reference);
        return projection;
    }

    /// <summary>What PROJ's form of a coordinate system leaves out: that longitudes count to the west, or are not in degrees.</summary>
    private static string WordsThatProj4Lacks(GdalNative gdal, nint reference)
    {
        string words = string.Empty;
        bool isGeographic = gdal.OSRIsGeographic(reference) != 0;
        fixed (byte* geographic = "GEOGCS"u8, projected = "PROJCS"u8)
        {
            for (int axis = 0; axis < 2; axis++)
            {
                int direction = 0;
                gdal.OSRGetAxis(reference, isGeographic ? geographic : projected, axis, &direction);
                words = direction == GdalNative.West ? " +axis=wnu" : words;
            }
        }

        bool isInDegrees = !isGeographic
            || Math.Abs(double.RadiansToDegrees(gdal.OSRGetAngularUnits(reference, null)) - 1.0) < SameUnit;
        return isInDegrees ? words : words + Invariant($" +angular_unit={gdal.OSRGetAngularUnits(reference, null):R}");
    }
}
