using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Interop;

/// <summary>Writes a map with GDAL's driver of Cloud Optimized GeoTIFFs: in tiles, with coarser levels, without loss.</summary>
internal static unsafe class GdalMapWriter
{
    /// <summary>Writes one map.</summary>
    /// <param name="path">The file.</param>
    /// <param name="values">Line by line from the top.</param>
    /// <param name="samples">Cells of a line.</param>
    /// <param name="corner">X and Y of the upper left corner, and the width of a cell, m.</param>
    /// <param name="proj4">The projection in PROJ's words.</param>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL 3.1 is missing, or fails.</exception>
    public static void Write(
        string path, float[] values, int samples, (double Left, double Top, double Cell) corner, string proj4, string? libraryPath)
    {
        GdalNative gdal = GdalLibrary.Require(libraryPath, "A map as GeoTIFF");
        nint written = 0;
        fixed (float* start = values)
        fixed (byte* opensMemory = "GDAL_MEM_ENABLE_OPEN"u8, yes = "YES"u8)
        {
            // A raster in memory that GDAL opens by its address, so that it needs no copy; from version 3.10 on only where that is allowed.
            gdal.CPLSetConfigOption(opensMemory, yes);
            nint memory = Open(gdal, string.Create(
                CultureInfo.InvariantCulture,
                $"MEM:::DATAPOINTER={(nint)start},PIXELS={samples},LINES={values.Length / samples},DATATYPE=Float32,"
                    + $"GEOTRANSFORM={corner.Left:R}/{corner.Cell:R}/0/{corner.Top:R}/0/{-corner.Cell:R}"));
            if (memory != 0)
            {
                written = Copy(gdal, path, memory, proj4);
                gdal.GDALClose(memory);
            }
        }

        if (written == 0)
        {
            throw new ExternalPartException(
                $"{path}: GDAL can't write it ({Marshal.PtrToStringUTF8((nint)gdal.CPLGetLastErrorMsg())}). GDAL 3.1 or later is "
                    + "needed, and room on the disk; or choose --format npy.");
        }

        gdal.GDALClose(written);
    }

    private static nint Open(GdalNative gdal, string name)
    {
        fixed (byte* text = Encoding.UTF8.GetBytes(name + '\0'))
        {
            return gdal.GDALOpenEx(text, GdalNative.OpenRaster, 0, 0, 0);
        }
    }

    private static nint Copy(GdalNative gdal, string path, nint source, string projection)
    {
        string[] words = ["-of", "COG", "-a_srs", projection, "-co", "COMPRESS=DEFLATE", "-co", "OVERVIEWS=AUTO"];
        nint[] texts = [.. words.Select(Marshal.StringToCoTaskMemUTF8), 0];
        nint options;
        fixed (nint* start = texts)
        {
            options = gdal.GDALTranslateOptionsNew((byte**)start, 0);
        }

        Array.ForEach(texts, Marshal.FreeCoTaskMem);
        if (options == 0)
        {
            return 0;
        }

        fixed (byte* name = Encoding.UTF8.GetBytes(path + '\0'))
        {
            nint written = gdal.GDALTranslate(name, source, options, null);
            gdal.GDALTranslateOptionsFree(options);
            return written;
        }
    }
}
