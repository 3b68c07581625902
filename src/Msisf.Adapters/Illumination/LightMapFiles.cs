using System.Runtime.InteropServices;
using System.Text.Json;
using Msisf.Adapters.Interop;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Maps;
using Msisf.Adapters.Metadata;
using Msisf.Core.Ephemeris;
using Msisf.Core.Layers;
using Msisf.Core.Maps;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Illumination;

/// <summary>Writes maps of light. Cells without data are NaN.</summary>
/// <param name="grid">Where the cells lie.</param>
/// <param name="body">The body.</param>
/// <param name="origin">What the maps are made by and from.</param>
/// <param name="times">The times that they tell of.</param>
public sealed class LightMapFiles(MapGrid grid, CelestialBody body, MapOrigin origin, MapTimes times)
{
    private readonly MapReference _reference = MapReference.Of(grid.Projection, body);

    /// <summary>Writes a map as array of NumPy.</summary>
    /// <exception cref="ExternalPartException">The disk is full, or refuses.</exception>
    public void WriteNpy(string path, LightMap map) => AtomicFile.Write(path, stream =>
    {
        NpyFile.WriteHead(stream, LayerType.Real32, grid.Lines, grid.Samples);
        stream.Write(MemoryMarshal.AsBytes(map.Values.AsSpan()));
    });

    /// <summary>Writes what arrays have no place for: where the cells lie, what the maps hold, and what they are made from.</summary>
    /// <param name="files">Names of the maps' files.</param>
    /// <exception cref="ExternalPartException">The disk is full, or refuses.</exception>
    public void WriteJson(string path, IReadOnlyList<(LightMap Map, string Name)> files) => AtomicFile.Write(path, stream =>
    {
        using (Utf8JsonWriter json = new(stream, new JsonWriterOptions { Indented = true, NewLine = "\n" }))
        {
            json.WriteStartObject();
            json.WriteString("creator", $"MSISF {origin.Version}");
            json.WriteString("commandLine", origin.Command);
            InputsJson.Write(json, origin.Inputs);
            json.WriteString("body", body.Name);
            json.WriteString("crs", _reference.Name);
            json.WriteString("crsWkt", _reference.Wkt);
            json.WriteString("crsUnit", grid.Projection.IsInDegrees ? "degree" : "m");
            json.WriteNumber("lines", grid.Lines);
            json.WriteNumber("samples", grid.Samples);
            json.WriteNumber("left", grid.Left);
            json.WriteNumber("top", grid.Top);
            json.WriteNumber("cellWidth", grid.CellWidth);
            json.WriteNumber("cellHeight", grid.CellHeight);
            json.WriteString("start", times.Start);
            json.WriteString("end", times.End);
            json.WriteNumber("stepHours", times.StepHours);
            json.WriteString("sun", times.Sun);
            json.WriteString("noData", "NaN");
            json.WriteStartArray("maps");
            foreach ((LightMap map, string name) in files)
            {
                json.WriteStartObject();
                json.WriteString("name", map.Name);
                json.WriteString("file", name);
                json.WriteString("unit", map.Unit);
                json.WriteString("description", map.Meaning);
                json.WriteNumber("heightOverGroundM", map.Height);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
    });

    /// <summary>Writes maps as one FITS file, an image extension each; the first row of the file is the map's top.</summary>
    /// <exception cref="ExternalPartException">CFITSIO is missing, or the disk refuses.</exception>
    public void WriteFits(string path, IReadOnlyList<LightMap> maps)
    {
        FitsLayerWriter.RequireCFitsio();
        AtomicFile.Write(path, stream =>
        {
            using (FitsUnit primary = FitsUnit.Primary())
            {
                primary.DeclareLongTexts();
                primary.Put("CREATOR", FitsText.Ascii($"MSISF {origin.Version}"), "program and version");
                primary.Put("CMDLINE", FitsText.Ascii(origin.Command), "arguments of the call");
                FitsProvenance.PutInputs(primary, origin.Inputs);
                primary.Put("OBJECT", body.Name, string.Empty);
                if (_reference.Name is { } name)
                {
                    primary.Put("CRS", name, "coordinate reference system");
                }

                primary.Put("CRSWKT", FitsText.Ascii(_reference.Wkt), "the same in words");
                primary.Put("TIMESYS", "UTC", "time system");
                primary.Put("DATE-BEG", times.Start.TrimEnd('Z'), "first time that is looked at");
                primary.Put("DATE-END", times.End.TrimEnd('Z'), "last time that is looked at");
                primary.Put("STEP", times.StepHours, "[h] from one time to the next");
                primary.Put("SUN", times.Sun, "what the Sun is taken for");
                primary.CopyTo(stream);
            }

            foreach (LightMap map in maps)
            {
                using FitsUnit image = FitsUnit.Image(path: null, -32, grid.Samples, grid.Lines);
                image.Put("EXTNAME", map.Name.ToUpperInvariant(), "map");
                if (map.Unit.Length > 0)
                {
                    image.Put("BUNIT", map.Unit, "unit of the values");
                }

                image.Put("OBJECT", body.Name, string.Empty);
                MapWcs.Put(image, grid, body);
                image.Put("HEIGHT", map.Height, "[m] over the ground");
                image.Put("ROWORDER", "TOP-DOWN", "first row of the file is the map's top");
                image.PutComment(map.Meaning);
                image.Write<float>(0, map.Values);
                image.CopyTo(stream);
            }
        });
    }

    /// <summary>Writes a map as Cloud Optimized GeoTIFF, whose band says what it holds.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL 3.1 is missing, or fails.</exception>
    public void WriteGeoTiff(string path, LightMap map, string? libraryPath) => AtomicFile.Write(path, stream => GdalMapWriter.Write(
        stream,
        MemoryMarshal.AsBytes(map.Values.AsSpan()),
        new GdalMap("Float32", grid, _reference.Wkt, "nan")
        {
            Description = map.Meaning,
            Unit = map.Unit,
            Metadata =
            [
                ("MAP", map.Name),
                ("HEIGHT_OVER_GROUND_M", Invariant($"{map.Height:R}")),
                ("TIME_START", times.Start),
                ("TIME_END", times.End),
                ("TIME_STEP_HOURS", Invariant($"{times.StepHours:R}")),
                ("SUN", times.Sun),
                .. _reference.Items,
                .. origin.Items,
            ],
        },
        libraryPath));
}
