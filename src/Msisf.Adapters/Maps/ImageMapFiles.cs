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
/// <param name="frame">Metadata of the image.</param>
/// <param name="libraryPath">MSISF_GDAL, or null.</param>
public sealed class ImageMapFiles(ImageMap map, FrameMetadata frame, string? libraryPath)
{
    /// <summary>Cells of bytes that show nothing; no layer has it.</summary>
    private const byte NoByte = 255;

    private readonly MapReference _reference = MapReference.Of(map.Grid.Projection, frame.Globe.Body);
    private readonly IReadOnlyList<(string Key, string Value)> _origin =
    [
        .. new MapOrigin(frame.Version, frame.CommandLine, frame.Inputs).Items,
        ("RENDERER", frame.RendererName),
        ("TIME", frame.SimulationTime.ToIsoUtc()),
    ];

    /// <summary>Endings of the files, which follow the frame's name.</summary>
    public static IEnumerable<string> Endings =>
        [EndingOf(null), .. LayerCatalogue.All.Select(EndingOf)];

    /// <summary>Checks that GDAL is there, before any work is done.</summary>
    /// <exception cref="ExternalPartException">It is missing.</exception>
    public static void RequireGdal(string? libraryPath) => GdalMapWriter.RequireGdal(libraryPath);

    /// <summary>Writes the image: I/F, or the numbers of a detector.</summary>
    /// <param name="put">Receives the file.</param>
    public void WriteImage(PutFile put, ExportedImage image)
    {
        float[] numbers = new float[image.Width * image.Height];
        for (int row = 0; row < image.Height; row++)
        {
            image.ReadRow(row, numbers.AsSpan(row * image.Width, image.Width));
        }

        Write<float>(put, EndingOf(null), numbers, float.NaN, "Float32", [
            ("DESCRIPTION", image.IsDigital ? "Digital numbers of the detector" : "Radiance factor I/F")]);
    }

    /// <summary>Writes layers, each with its planes as bands.</summary>
    /// <param name="put">Receives the files.</param>
    /// <param name="provenance">Provenance of the frame.</param>
    /// <param name="precision">Precision of real numbers.</param>
    public void WriteLayers(
        PutFile put, IGroundTruth truth, LayerProvenance provenance, LayerSet layers, LayerPrecision precision,
        CancellationToken cancellation) => LayerPasses.Run(
        new LayerSampler(truth, provenance), layers.Layers, precision, LayerLayout.ForCFitsio, layer => WriteLayer(put, layer),
        cancellation);

    private void WriteLayer(PutFile put, StoredLayer layer)
    {
        string ending = EndingOf(layer.Layer);
        (string, string)[] about =
        [
            ("DESCRIPTION", frame.Globe.Describe(layer.Layer.Description)),
            .. layer.Layer.Unit.Length > 0 ? [("UNIT", layer.Layer.Unit)] : ((string, string)[])[],
            .. layer.Layer.PlaneNames.Select((name, plane) => (Invariant($"BAND{plane + 1}"), name)),
        ];
        switch (layer.Type)
        {
            case LayerType.Real64:
                Write(put, ending, MemoryMarshal.Cast<byte, double>(layer.Bytes), double.NaN, "Float64", about);
                break;
            case LayerType.Real32:
                Write(put, ending, MemoryMarshal.Cast<byte, float>(layer.Bytes), float.NaN, "Float32", about);
                break;
            case LayerType.Unsigned8:
                Write(put, ending, layer.Bytes, NoByte, "Byte", about);
                break;
            default:
                Write(put, ending, MemoryMarshal.Cast<byte, int>(layer.Bytes), Layer.UndefinedNumber, "Int32", about);
                break;
        }
    }

    private void Write<T>(
        PutFile put, string ending, ReadOnlySpan<T> numbers, T none, string type, (string Key, string Value)[] about)
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

        put(ending[1..], null, stream => GdalMapWriter.Write(
            stream,
            MemoryMarshal.AsBytes(values.AsSpan()),
            new GdalMap(type, map.Grid, _reference.Wkt, Invariant($"{none}"))
            {
                Bands = planes,
                Resampling = "NEAREST",
                Metadata = [.. about, .. _reference.Items, .. _origin],
            },
            libraryPath));
    }

    private static string EndingOf(Layer? layer) => layer is null ? ".map.tif" : $".{layer.Name}.map.tif";
}
