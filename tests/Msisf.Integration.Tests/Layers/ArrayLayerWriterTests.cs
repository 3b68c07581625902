using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Layers;

public sealed class ArrayLayerWriterTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Astropy)]
    [InlineData("depth", LayerPrecision.Real64, "(67, 101)", "float64")]
    [InlineData("mask", LayerPrecision.Real64, "(67, 101)", "uint8")]
    [InlineData("tile", LayerPrecision.Real64, "(67, 101)", "int32")]
    [InlineData("normal", LayerPrecision.Real64, "(67, 101, 3)", "float64")]
    [InlineData("cell", LayerPrecision.Real64, "(67, 101, 2)", "int32")]
    [InlineData("depth", LayerPrecision.Real32, "(67, 101)", "float32")]
    [InlineData("latitude", LayerPrecision.Real32, "(67, 101)", "float64")]
    [InlineData("normal", LayerPrecision.Real32, "(67, 101, 3)", "float32")]
    [InlineData("cell", LayerPrecision.Real32, "(67, 101, 2)", "int32")]
    public void Write_Layer_NumpyReadsItToTheBit(string name, LayerPrecision precision, string shape, string type)
    {
        Layer layer = Assert.Single(LayerSet.Parse(name).Layers);
        using (AtomicFileSet files = new())
        {
            ArrayLayerWriter.Write(
                files.Under(_folder["frame"], []), LayerFrame.Metadata, LayerFrame.Provenance, LayerFrame.Truth, LayerSet.Parse(name),
                precision);
            files.Commit();
        }

        Dictionary<string, string> said = LayerFrame.Read("numpy", _folder[$"frame.{name}.npy"], _folder.Path);

        Assert.Equal((shape, type), (said["shape"], said["dtype"]));
        Assert.Equal(PixelByPixel(layer, type == "float32"), File.ReadAllBytes(_folder["array.bin"]));
    }

    /// <summary>GDAL reads each plane as a page.</summary>
    [RequiresTheory(Part.Gdal)]
    [InlineData("depth", LayerPrecision.Real64, "(1, 67, 101)", "float64", "nan")]
    [InlineData("depth", LayerPrecision.Real32, "(1, 67, 101)", "float32", "nan")]
    [InlineData("mask", LayerPrecision.Real64, "(1, 67, 101)", "uint8", "None")]
    [InlineData("normal", LayerPrecision.Real32, "(3, 67, 101)", "float32", "nan")]
    [InlineData("cell", LayerPrecision.Real32, "(2, 67, 101)", "int32", "-2147483648.0")]
    public void Write_LayerAsTiff_GdalReadsItToTheBit(string name, LayerPrecision precision, string shape, string type, string undefined)
    {
        Layer layer = Assert.Single(LayerSet.Parse(name).Layers);
        using (AtomicFileSet files = new())
        {
            ArrayLayerWriter.Write(
                files.Under(_folder["frame"], []), LayerFrame.Metadata, LayerFrame.Provenance, LayerFrame.Truth, LayerSet.Parse(name),
                precision, ArrayFormat.Tiff);
            files.Commit();
        }

        Dictionary<string, string> said = LayerFrame.Read("tiff", _folder[$"frame.{name}.tif"], _folder.Path);

        Assert.Equal((shape, type, undefined), (said["shape"], said["dtype"], said["undefined"]));
        Assert.Equal(LayerFrame.ExpectedBytes(layer, type == "float32"), File.ReadAllBytes(_folder["array.bin"]));
        Assert.Equal($"MSISF {LayerFrame.Metadata.Version}", said["software"]);
        Assert.All(
            said["about"].Split('|'), (about, page) => Assert.StartsWith(
                layer.Planes > 1 ? $"{name} ({layer.PlaneNames[page]})" : name, about, StringComparison.Ordinal));
    }

    /// <summary>The planes' numbers side by side for each pixel.</summary>
    private static byte[] PixelByPixel(Layer layer, bool isSingle)
    {
        byte[] planes = LayerFrame.ExpectedBytes(layer, isSingle);
        int size = planes.Length / (layer.Planes * LayerFrame.Width * LayerFrame.Height);
        return
        [
            .. from pixel in Enumerable.Range(0, LayerFrame.Width * LayerFrame.Height)
               from plane in Enumerable.Range(0, layer.Planes)
               from i in Enumerable.Range(0, size)
               select planes[(((plane * LayerFrame.Width * LayerFrame.Height) + pixel) * size) + i],
        ];
    }
}
