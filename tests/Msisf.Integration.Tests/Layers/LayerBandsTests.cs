using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Layers;

/// <summary>Layers of an image that is drawn some rows at a time, against those of one that is kept as a whole.</summary>
public sealed class LayerBandsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>101 px and 7 rows: the bytes of the mask begin and end within a word of the checksum.</summary>
    [RequiresTheory(Part.CFitsio)]
    [InlineData("all", 7, LayerPrecision.Real64, LayerCompression.None)]
    [InlineData("mask,normal", 66, LayerPrecision.Real32, LayerCompression.None)]
    [InlineData("all", 7, LayerPrecision.Real32, LayerCompression.Gzip)]
    [InlineData("cell,normal", 1, LayerPrecision.Real64, LayerCompression.Gzip)]
    public void WriteFits_SomeRowsAtATime_SameBytes(string layers, int rows, LayerPrecision precision, LayerCompression compression)
    {
        string path = _folder["bands.fits"];
        using (FileStream stream = new(path, FileMode.CreateNew, FileAccess.Write))
        {
            FitsLayerWriter.Write(
                stream, LayerFrame.Metadata, LayerFrame.Provenance, InRows(rows), Set(layers), precision, compression);
        }

        Assert.Equal(LayerFrame.Fits(layers, precision, compression), File.ReadAllBytes(path));
        Assert.Equal([path], Directory.GetFiles(_folder.Path));
    }

    [Theory]
    [InlineData(ArrayFormat.Npy)]
    [InlineData(ArrayFormat.Tiff)]
    public void WriteArrays_SomeRowsAtATime_SameBytes(ArrayFormat format)
    {
        string[] whole = Arrays("whole", LayerFrame.Height, format);
        string[] bands = Arrays("bands", 7, format);

        Assert.Equal(LayerSet.OfAnyFrame.Layers.Count + 1, whole.Length);
        Assert.Equal(whole.Select(path => path.Replace("whole", "bands", StringComparison.Ordinal)), bands);
        Assert.All(whole.Zip(bands), pair => Assert.Equal(File.ReadAllBytes(pair.First), File.ReadAllBytes(pair.Second)));
    }

    private static LayerSet Set(string layers) => layers == "all" ? LayerSet.OfAnyFrame : LayerSet.Parse(layers);

    private static SphereTruth InRows(int rows) =>
        new(LayerFrame.Metadata.Camera, LayerFrame.Metadata.SunPositionBodyFixed, 16) { RowsAtOnce = rows };

    private string[] Arrays(string stem, int rows, ArrayFormat format)
    {
        using AtomicFileSet files = new();
        List<string> paths = [];
        ArrayLayerWriter.Write(
            files.Under(_folder[stem], paths), LayerFrame.Metadata, LayerFrame.Provenance, InRows(rows), LayerSet.OfAnyFrame,
            format: format);
        files.Commit();
        return [.. paths];
    }
}
