using System.Runtime.InteropServices;
using System.Text;
using Msisf.Core.Maps;

namespace Msisf.Adapters.Interop;

/// <summary>Writes a map with GDAL's driver of Cloud Optimized GeoTIFFs: in tiles, with coarser levels, without loss.</summary>
internal static unsafe class GdalMapWriter
{
    /// <summary>Checks that GDAL is there, before any work is done.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">It is missing.</exception>
    public static void RequireGdal(string? libraryPath) => GdalLibrary.Require(libraryPath, "A map as GeoTIFF");

    /// <summary>Writes one map.</summary>
    /// <param name="destination">Receives the file; stays open.</param>
    /// <param name="values">Band by band, line by line from the top, in the machine's byte order.</param>
    /// <param name="map">What they are.</param>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL 3.1 is missing, or fails.</exception>
    public static void Write(Stream destination, ReadOnlySpan<byte> values, GdalMap map, string? libraryPath)
    {
        GdalNative gdal = GdalLibrary.Require(libraryPath, "A map as GeoTIFF");
        string path = $"/vsimem/msisf-{Guid.NewGuid():N}.tif"; // GDAL writes into memory, so that a full disk is this program's error
        nint written = 0;
        fixed (byte* start = values, opensMemory = "GDAL_MEM_ENABLE_OPEN"u8, yes = "YES"u8, file = Encoding.UTF8.GetBytes(path + '\0'))
        {
            // A raster in memory that GDAL opens by its address, so that it needs no copy; from version 3.10 on only where that is allowed.
            gdal.CPLSetConfigOption(opensMemory, yes);
            nint memory = Open(gdal, Invariant(
                $"MEM:::DATAPOINTER={(nint)start},PIXELS={map.Grid.Samples},LINES={map.Grid.Lines},BANDS={map.Bands},DATATYPE={map.Type},"
                    + $"GEOTRANSFORM={map.Grid.Left:R}/{map.Grid.CellWidth:R}/0/{map.Grid.Top:R}/0/{-map.Grid.CellHeight:R}"));
            if (memory != 0)
            {
                Describe(gdal, gdal.GDALGetRasterBand(memory, 1), map);
                written = Copy(gdal, path, memory, map);
                gdal.GDALClose(memory);
            }

            if (written == 0)
            {
                throw new ExternalPartException(
                    $"GDAL can't write a map ({Marshal.PtrToStringUTF8((nint)gdal.CPLGetLastErrorMsg())}). GDAL 3.1 or later is needed.");
            }

            gdal.GDALClose(written);
            try
            {
                using GdalStream content = new(path);
                content.CopyTo(destination);
            }
            finally
            {
                _ = gdal.VSIUnlink(file);
            }
        }
    }

    private static nint Open(GdalNative gdal, string name)
    {
        fixed (byte* text = Encoding.UTF8.GetBytes(name + '\0'))
        {
            return gdal.GDALOpenEx(text, GdalNative.OpenRaster, 0, 0, 0);
        }
    }

    private static void Describe(GdalNative gdal, nint band, GdalMap map)
    {
        fixed (byte* description = Encoding.UTF8.GetBytes(map.Description + '\0'), unit = Encoding.UTF8.GetBytes(map.Unit + '\0'))
        {
            gdal.GDALSetDescription(band, description);
            _ = gdal.GDALSetRasterUnitType(band, unit);
        }
    }

    private static nint Copy(GdalNative gdal, string path, nint source, GdalMap map)
    {
        string[] words =
        [
            "-of", "COG", "-a_srs", map.Wkt, "-a_nodata", map.NoData, "-co", "COMPRESS=DEFLATE", "-co", "OVERVIEWS=AUTO",
            .. map.Resampling is { } resampling ? (string[])["-co", $"OVERVIEW_RESAMPLING={resampling}"] : [],
            .. map.Metadata.SelectMany(item => (string[])["-mo", $"{item.Key}={item.Value}"]),
        ];
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

/// <summary>What GDAL needs to know of a map.</summary>
/// <param name="Type">Type of its numbers, in GDAL's words.</param>
/// <param name="Grid">Its cells.</param>
/// <param name="Wkt">Its coordinate reference system.</param>
/// <param name="NoData">The number of cells without data.</param>
internal sealed record GdalMap(string Type, MapGrid Grid, string Wkt, string NoData)
{
    /// <summary>Numbers of a cell.</summary>
    public int Bands { get; init; } = 1;

    /// <summary>What the first band holds, as programs show it; empty for nothing.</summary>
    public string Description { get; init; } = string.Empty;

    /// <summary>Unit of the first band's numbers; empty for none.</summary>
    public string Unit { get; init; } = string.Empty;

    /// <summary>How coarser levels are made, in GDAL's words; null for its own choice.</summary>
    public string? Resampling { get; init; }

    /// <summary>What the file says of its content and its origin.</summary>
    public IReadOnlyList<(string Key, string Value)> Metadata { get; init; } = [];
}
