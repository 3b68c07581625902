using System.Runtime.InteropServices;
using Msisf.Adapters.Interop;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Illumination;

/// <summary>Writes maps of light.</summary>
public static class LightMapFiles
{
    /// <summary>Writes a map as array of NumPy.</summary>
    /// <exception cref="ExternalPartException">The disk is full, or refuses.</exception>
    public static void WriteNpy(string path, LightMap map, MapPlacement placement) => AtomicFile.Write(path, stream =>
    {
        NpyFile.WriteHead(stream, LayerType.Real32, placement.Lines, placement.Samples);
        stream.Write(MemoryMarshal.AsBytes(map.Values.AsSpan()));
    });

    /// <summary>Writes maps as one FITS file, an image extension each; the first row of the file is the map's top.</summary>
    /// <exception cref="ExternalPartException">CFITSIO is missing, or the disk refuses.</exception>
    public static void WriteFits(string path, IReadOnlyList<LightMap> maps, MapPlacement placement)
    {
        FitsLayerWriter.RequireCFitsio();
        AtomicFile.Write(path, stream =>
        {
            using (FitsUnit primary = FitsUnit.Primary())
            {
                primary.DeclareLongTexts();
                primary.Put("PROJ4", placement.Proj4, "projection");
                primary.Put("CELL", placement.Cell, "[m] width of a cell");
                primary.Put("LEFT", placement.Left, "[m] X of the left edge");
                primary.Put("TOP", placement.Top, "[m] Y of the upper edge");
                primary.CopyTo(stream);
            }

            foreach (LightMap map in maps)
            {
                using FitsUnit image = FitsUnit.Image(path: null, -32, placement.Samples, placement.Lines);
                image.Put("EXTNAME", map.Name.ToUpperInvariant(), "map");
                if (map.Unit.Length > 0)
                {
                    image.Put("BUNIT", map.Unit, "unit of the values");
                }

                image.Put("ROWORDER", "TOP-DOWN", "first row of the file is the map's top");
                image.PutComment(map.Meaning);
                image.Write<float>(0, map.Values);
                image.CopyTo(stream);
            }
        });
    }

    /// <summary>Writes a map as Cloud Optimized GeoTIFF.</summary>
    /// <param name="placement">Where its cells lie.</param>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL 3.1 is missing, or fails.</exception>
    public static void WriteGeoTiff(string path, LightMap map, MapPlacement placement, string? libraryPath) =>
        AtomicFile.Write(path, stream => GdalMapWriter.Write(
            stream,
            MemoryMarshal.AsBytes(map.Values.AsSpan()),
            new GdalMap("Float32", placement.Samples, placement.Lines, (placement.Left, placement.Top, placement.Cell), placement.Proj4),
            libraryPath));
}
