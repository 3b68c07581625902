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
    public static void WriteFits(string path, IReadOnlyList<LightMap> maps, MapPlacement placement, MapTimes times)
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
                primary.Put("TIMESYS", "UTC", "time system");
                primary.Put("DATE-BEG", times.Start.TrimEnd('Z'), "first time that is looked at");
                primary.Put("DATE-END", times.End.TrimEnd('Z'), "last time that is looked at");
                primary.Put("STEP", times.StepHours, "[h] from one time to the next");
                primary.Put("SUN", times.Sun, "what the Sun is taken for");
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

                image.Put("HEIGHT", map.Height, "[m] over the ground");
                image.Put("ROWORDER", "TOP-DOWN", "first row of the file is the map's top");
                image.PutComment(map.Meaning);
                image.Write<float>(0, map.Values);
                image.CopyTo(stream);
            }
        });
    }

    /// <summary>Writes a map as Cloud Optimized GeoTIFF, whose band says what it holds.</summary>
    /// <param name="placement">Where its cells lie.</param>
    /// <param name="times">The times that it tells of.</param>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL 3.1 is missing, or fails.</exception>
    public static void WriteGeoTiff(string path, LightMap map, MapPlacement placement, MapTimes times, string? libraryPath) =>
        AtomicFile.Write(path, stream => GdalMapWriter.Write(
            stream,
            MemoryMarshal.AsBytes(map.Values.AsSpan()),
            new GdalMap("Float32", placement.Samples, placement.Lines, (placement.Left, placement.Top, placement.Cell), placement.Proj4)
            {
                Description = map.Meaning,
                Unit = map.Unit,
                MoreOptions =
                [
                    "-mo", $"MAP={map.Name}",
                    "-mo", Invariant($"HEIGHT_OVER_GROUND_M={map.Height:R}"),
                    "-mo", $"TIME_START={times.Start}",
                    "-mo", $"TIME_END={times.End}",
                    "-mo", Invariant($"TIME_STEP_HOURS={times.StepHours:R}"),
                    "-mo", $"SUN={times.Sun}",
                ],
            },
            libraryPath));
}
