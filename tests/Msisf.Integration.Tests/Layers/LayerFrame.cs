using System.Runtime.InteropServices;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Integration.Tests.Metadata;
using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Layers;

/// <summary>A small frame with day, night and space in it, and what its layers hold.</summary>
internal static class LayerFrame
{
    /// <summary>Odd sizes: no row and no plane of bytes ends where a FITS block or a word does.</summary>
    public const int Width = 101;

    public const int Height = 67;

    public static LayerProvenance Provenance { get; } = new("LDEM_16", 16, 2, "native", SpectralBand.Default);

    public static FrameMetadata Metadata { get; } = ExampleFrame.OfSize(Width, Height) with
    {
        SunPositionBodyFixed = new Vector3D(1.07e11, -1.04e11, 4e9),
        CommandLine = $"--output-dir 'Mond \u00e4' {string.Concat(Enumerable.Repeat("--a 'quoted' & long ", 30))}end",
    };

    public static SphereTruth Truth { get; } = new(Metadata.Camera, Metadata.SunPositionBodyFixed, 16);

    public static byte[] Fits(
        string layers = "all", LayerPrecision precision = LayerPrecision.Real64, LayerCompression compression = LayerCompression.None)
    {
        using MemoryStream stream = new();
        FitsLayerWriter.Write(
            stream, Metadata, Provenance, Truth,
            layers == "all" ? LayerSet.OfAnyFrame : LayerSet.Parse(layers), precision, compression);
        return stream.ToArray();
    }

    /// <summary>A layer's numbers as bytes: plane by plane, each by rows from the top.</summary>
    /// <param name="layer">The layer.</param>
    /// <param name="isSingle">Whether its real numbers are rounded to single precision.</param>
    public static byte[] ExpectedBytes(Layer layer, bool isSingle = false)
    {
        LayerSampler sampler = new(Truth, Provenance);
        double[][] planes = [.. Enumerable.Range(0, layer.Planes).Select(_ => new double[Width * Height])];
        for (int row = 0; row < Height; row++)
        {
            sampler.SampleRow(row, [layer], planes, row * Width);
        }

        double[] values = [.. planes.SelectMany(plane => plane)];
        return layer.Type switch
        {
            LayerType.Real64 when isSingle => MemoryMarshal.AsBytes<float>([.. values.Select(value => (float)value)]).ToArray(),
            LayerType.Real64 => MemoryMarshal.AsBytes<double>(values).ToArray(),
            LayerType.Unsigned8 => [.. values.Select(value => (byte)value)],
            _ => MemoryMarshal.AsBytes<int>([.. values.Select(value => double.IsNaN(value) ? int.MinValue : (int)value)]).ToArray(),
        };
    }

    /// <summary>Runs read_layers.py.</summary>
    /// <returns>What it printed, by name.</returns>
    public static Dictionary<string, string> Read(string reader, string path, string folder)
    {
        string script = Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "Layers", "read_layers.py");
        string output = ChildRun.Of(TestParts.Python!, [script, reader, path, folder], folder).Succeeded().Output;
        return output.Split(
            '\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split('=', 2)).ToLookup(pair => pair[0], pair => pair[^1])
            .ToDictionary(group => group.Key, group => group.First());
    }
}
