using System.Runtime.InteropServices;
using Msisf.Adapters.CameraExport;
using Msisf.Adapters.Interop;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.Core.Maps;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.Adapters.Maps;

/// <summary>
/// Writes images and their layers on a map, as Cloud Optimized GeoTIFFs. A cell has the number of the pixel in which its middle is seen.
/// </summary>
/// <param name="map">Which pixel each cell shows.</param>
/// <param name="globe">The body.</param>
/// <param name="libraryPath">MSISF_GDAL, or null.</param>
public sealed class ImageMapFiles(ImageMap map, DrawnGlobe globe, string? libraryPath)
{
    /// <summary>Cells of bytes that show nothing; no layer has it.</summary>
    private const byte NoByte = 255;

    /// <summary>Endings of the files, which follow the frame's name.</summary>
    public static IEnumerable<string> Endings =>
        [EndingOf(null), .. LayerCatalogue.All.Select(EndingOf)];

    /// <summary>Checks that GDAL is there, before any work is done.</summary>
    /// <exception cref="ExternalPartException">It is missing.</exception>
    public static void RequireGdal(string? libraryPath) => GdalMapWriter.RequireGdal(libraryPath);

    /// <summary>Writes the image: I/F, or the numbers of a detector.</summary>
    /// <param name="files">Receives the file.</param>
    /// <param name="stem">Path of the frame's files, without extension.</param>
    /// <returns>Its path.</returns>
    public string WriteImage(AtomicFileSet files, string stem, ExportedImage image)
    {
        float[] numbers = new float[image.Width * image.Height];
        for (int row = 0; row < image.Height; row++)
        {
            image.ReadRow(row, numbers.AsSpan(row * image.Width, image.Width));
        }

        return Write<float>(files, stem + EndingOf(null), numbers, float.NaN, "Float32", [
            $"DESCRIPTION={(image.IsDigital ? "Digital numbers of the detector" : "Radiance factor I/F")}"]);
    }

    /// <summary>Writes layers, each with its planes as bands.</summary>
    /// <param name="files">Receives the files.</param>
    /// <param name="stem">Path of the frame's files, without extension.</param>
    /// <param name="provenance">Of the frame.</param>
    /// <param name="precision">Of real numbers.</param>
    /// <returns>Their paths.</returns>
    public IReadOnlyList<string> WriteLayers(
        AtomicFileSet files, string stem, IGroundTruth truth, LayerProvenance provenance, LayerSet layers, LayerPrecision precision,
        CancellationToken cancellation)
    {
        List<string> paths = [];
        LayerSampler sampler = new(truth, provenance);
        LayerPasses.Run(
            sampler, layers.Layers, precision, LayerLayout.ForCFitsio, layer => paths.Add(WriteLayer(files, stem, layer)), cancellation);
        return paths;
    }

    private string WriteLayer(AtomicFileSet files, string stem, StoredLayer layer)
    {
        string path = stem + EndingOf(layer.Layer);
        string[] about =
        [
            $"DESCRIPTION={globe.Describe(layer.Layer.Description)}",
            .. layer.Layer.Unit.Length > 0 ? [$"UNIT={layer.Layer.Unit}"] : (string[])[],
            .. layer.Layer.PlaneNames.Select((name, plane) => Invariant($"BAND{plane + 1}={name}")),
        ];
        return layer.Type switch
        {
            LayerType.Real64 => Write(files, path, MemoryMarshal.Cast<byte, double>(layer.Bytes), double.NaN, "Float64", about),
            LayerType.Real32 => Write(files, path, MemoryMarshal.Cast<byte, float>(layer.Bytes), float.NaN, "Float32", about),
            LayerType.Unsigned8 => Write(files, path, layer.Bytes, NoByte, "Byte", about),
            _ => Write(files, path, MemoryMarshal.Cast<byte, int>(layer.Bytes), Layer.UndefinedNumber, "Int32", about),
        };
    }

    private string Write<T>(AtomicFileSet files, string path, ReadOnlySpan<T> numbers, T none, string type, string[] about)
        where T : unmanaged
    {
        int cells = map.Pixels.Length;
        int planes = numbers.Length / map.ImagePixels;
        T[] values = new T[(long)cells * planes];
        for (int plane = 0; plane < planes; plane++)
        {
            ReadOnlySpan<T> ofImage = numbers.Slice(plane * map.ImagePixels, map.ImagePixels);
            Span<T> ofMap = values.AsSpan(plane * cells, cells);
            for (int cell = 0; cell < cells; cell++)
            {
                ofMap[cell] = map.Pixels[cell] < 0 ? none : ofImage[map.Pixels[cell]];
            }
        }

        files.Write(path, stream => GdalMapWriter.Write(
            stream,
            MemoryMarshal.AsBytes(values.AsSpan()),
            new GdalMap(type, map.Samples, map.Lines, (map.Left, map.Top, map.Cell), MapReference.WktOf(map.Projection, globe))
            {
                Bands = planes,
                MoreOptions =
                [
                    "-a_nodata", Invariant($"{none}"), "-co", "OVERVIEW_RESAMPLING=NEAREST",
                    .. about.SelectMany(text => (string[])["-mo", text]),
                ],
            },
            libraryPath));
        return path;
    }

    private static string EndingOf(Layer? layer) => layer is null ? ".map.tif" : $".{layer.Name}.map.tif";
}

/// <summary>Says in the words of the OGC (WKT, version 1) how a map lies on a body.</summary>
internal static class MapReference
{
    /// <summary>The text.</summary>
    public static string WktOf(ImageMapProjection projection, DrawnGlobe globe)
    {
        string body = globe.Body.IsMoon ? "Moon_2000" : $"{globe.Body.Name}_sphere";
        string latitude = Degrees(projection.Latitude);
        (string name, string method, string parameters) = projection.Kind switch
        {
            MapKind.Equirectangular =>
                ("equirectangular", "Equirectangular", "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"standard_parallel_1\",0]"),
            MapKind.PolarStereographic =>
                ("polar stereographic", "Polar_Stereographic",
                    $"PARAMETER[\"latitude_of_origin\",{latitude}],PARAMETER[\"scale_factor\",1]"),
            _ => ("orthographic", "Orthographic", $"PARAMETER[\"latitude_of_origin\",{latitude}]"),
        };
        return Invariant(
            $"PROJCS[\"{globe.Body.Name} {name}\",GEOGCS[\"GCS_{body}\",DATUM[\"D_{body}\","
                + $"SPHEROID[\"{body}\",{globe.ReferenceRadius:R},0]],PRIMEM[\"Reference_Meridian\",0],"
                + $"UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"{method}\"],{parameters},"
                + $"PARAMETER[\"central_meridian\",{Degrees(projection.Longitude)}],PARAMETER[\"false_easting\",0],"
                + $"PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]");
    }

    private static string Degrees(double angle) =>
        Math.Round(double.RadiansToDegrees(angle), 9).ToString("R", CultureInfo.InvariantCulture);
}
