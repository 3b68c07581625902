using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>A file format of layers; <c>default</c> is none.</summary>
/// <param name="Word">The word for it on the command line.</param>
/// <param name="Endings">Endings of the files, which follow the frame's name; NAME stands for that of each layer.</param>
/// <param name="Write">Writes the layers.</param>
/// <param name="Require">Checks for the library that it needs, before any work is done.</param>
internal readonly record struct LayerFormat(
    string Word, IReadOnlyList<string> Endings, Action<LayersOfFrame, PutFile> Write, Action Require)
{
    private const string NameOfLayer = "NAME";

    public static LayerFormat Fits { get; } = new(
        "fits", [".fits"],
        static (of, put) => put("fits", null, stream => FitsLayerWriter.Write(
            stream, of.Metadata, of.Provenance, of.Truth, of.Layers, of.Precision, of.Compression, of.Cancellation)),
        FitsLayerWriter.RequireCFitsio);

    public static LayerFormat Npy { get; } = new(
        "npy", [$".{NameOfLayer}.npy", ".rowstates.npy", ".layers.json"],
        static (of, put) => WriteArrays(of, put, ArrayFormat.Npy), static () => { });

    public static LayerFormat Tiff { get; } = new(
        "tiff", [$".{NameOfLayer}.tif", ".rowstates.npy", ".layers.json"],
        static (of, put) => WriteArrays(of, put, ArrayFormat.Tiff), static () => { });

    public static IReadOnlyList<LayerFormat> All { get; } = [Fits, Npy, Tiff];

    /// <summary>All endings that files of layers can have, in any format.</summary>
    /// <param name="layers">Names of the layers.</param>
    public static IEnumerable<string> EndingsOf(IReadOnlyList<string> layers) => All
        .SelectMany(format => format.Endings)
        .SelectMany(ending => ending.Contains(NameOfLayer, StringComparison.Ordinal)
            ? layers.Select(layer => ending.Replace(NameOfLayer, layer, StringComparison.Ordinal))
            : [ending])
        .Distinct();

    private static void WriteArrays(LayersOfFrame of, PutFile put, ArrayFormat format) => ArrayLayerWriter.Write(
        put, of.Metadata, of.Provenance, of.Truth, of.Layers, of.Precision, format, of.Cancellation);
}

/// <summary>Layers of a frame, and how they are written.</summary>
/// <param name="Metadata">Goes into their files.</param>
/// <param name="Provenance">Goes there too.</param>
/// <param name="Truth">What the pixels show; its camera is the frame's.</param>
internal sealed record LayersOfFrame(FrameMetadata Metadata, LayerProvenance Provenance, IGroundTruth Truth, LayerSet Layers)
{
    public LayerPrecision Precision { get; init; } = LayerPrecision.Real64;

    public LayerCompression Compression { get; init; }

    public CancellationToken Cancellation { get; init; }
}
