using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Layers;

public sealed class FitsLayerWriterTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.CFitsio, Part.Fitsverify)]
    [InlineData("all", LayerPrecision.Real64, LayerCompression.None)]
    [InlineData("mask", LayerPrecision.Real64, LayerCompression.None)]
    [InlineData("all", LayerPrecision.Real32, LayerCompression.Gzip)]
    public void Write_Layers_PassFitsverifyWithoutAWarning(string layers, LayerPrecision precision, LayerCompression compression)
    {
        string path = _folder.Write("frame.fits", LayerFrame.Fits(layers, precision, compression));

        string output = ChildRun.Of(TestParts.Program("fitsverify")!, [path], "/").Output;

        Assert.Contains("Verification found 0 warning(s) and 0 error(s)", output, StringComparison.Ordinal);
    }

    [RequiresFact(Part.CFitsio, Part.Fitsverify)]
    public void Fitsverify_ChangedBit_Complains()
    {
        // The check above can fail: the last bytes of the file are fill, some way before them is data.
        byte[] file = LayerFrame.Fits("depth");
        file[^30000] ^= 1;
        string path = _folder.Write("frame.fits", file);

        string output = ChildRun.Of(TestParts.Program("fitsverify")!, [path], "/").Output;

        Assert.DoesNotContain("found 0 warning(s)", output, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.CFitsio, Part.Astropy)]
    [InlineData(LayerPrecision.Real64, LayerCompression.None)]
    [InlineData(LayerPrecision.Real64, LayerCompression.Gzip)]
    [InlineData(LayerPrecision.Real32, LayerCompression.None)]
    [InlineData(LayerPrecision.Real32, LayerCompression.Gzip)]
    public void Write_AllLayers_AstropyReadsThemToTheBit(LayerPrecision precision, LayerCompression compression) =>
        AssertReadToTheBit("astropy", precision, compression);

    /// <summary>K, R and t of the header, and the points of POSITION, in numpy.</summary>
    [RequiresFact(Part.CFitsio, Part.Astropy)]
    public void Write_Camera_ProjectsThePositionsOntoTheirPixels()
    {
        Dictionary<string, string> said = LayerFrame.Read(
            "projection", _folder.Write("frame.fits", LayerFrame.Fits("position")), _folder.Path);

        Assert.InRange(Number(said["pixels"]), 1000.0, LayerFrame.Width * LayerFrame.Height);
        Assert.InRange(Number(said["error"]), 0.0, 1e-8); // px
    }

    [RequiresFact(Part.CFitsio, Part.Astropy, Part.Gdal)]
    public void Write_AllLayers_GdalReadsThemToTheBit() => AssertReadToTheBit("gdal", LayerPrecision.Real64, LayerCompression.None);

    [RequiresFact(Part.CFitsio, Part.Astropy)]
    public void Write_CompressedHeaders_AreThoseOfTheImages()
    {
        Dictionary<string, string> plain = LayerFrame.Read("astropy", _folder.Write("plain.fits", LayerFrame.Fits()), _folder.Path);

        Dictionary<string, string> compressed = LayerFrame.Read(
            "astropy", _folder.Write("compressed.fits", LayerFrame.Fits(compression: LayerCompression.Gzip)), _folder.Path);

        Assert.Contains("CELL.BLANK", plain.Keys);
        Assert.Equal(Headers(plain), Headers(compressed));
    }

    [RequiresFact(Part.CFitsio, Part.Astropy)]
    public void Write_Headers_HaveUnitsFramesAndProvenance()
    {
        Dictionary<string, string> said = LayerFrame.Read("astropy", _folder.Write("frame.fits", LayerFrame.Fits()), _folder.Path);

        Assert.Equal("MSISF 1.0.0", said["CREATOR"]);
        Assert.Equal(LayerFrame.Metadata.CommandLine, Regex.Unescape(said["CMDLINE"]));
        Assert.Equal("native", said["RENDERER"]);
        Assert.Equal("UTC", said["TIMESYS"]);
        Assert.Equal("2010-04-03T00:00:00", said["DATE-OBS"]);
        Assert.Equal(55289.0, Number(said["MJD-OBS"]));
        Assert.Equal(LayerFrame.Metadata.Camera.MoonFromCamera.X, Number(said["CAMQX"]));
        Assert.Equal(LayerFrame.Metadata.Camera.MoonFromCamera.W, Number(said["CAMQ0"]));
        Assert.Equal(LayerFrame.Metadata.Camera.PositionBodyFixed.Y, Number(said["CAMPOSY"]));
        Assert.Equal(LayerFrame.Metadata.FlightAltitude, Number(said["CAMALT"]));
        Assert.Equal(LayerFrame.Metadata.HeightOverTerrain, Number(said["CAMTERR"]));
        Assert.Equal(-1.04e11, Number(said["SUNPOSY"]));
        Assert.Equal(40.0, Number(said["CAMFOV"]));
        Assert.Equal(("LDEM_16", "64", "2", "16"), (said["ELEVMODL"], said["ELEVRES"], said["LOD"], said["MESHRES"]));
        Assert.Equal(("m", "deg"), (said["POSITION.BUNIT"], said["PHASE.BUNIT"]));
        Assert.Equal(("101", "67", "3"), (said["NORMAL.NAXIS1"], said["NORMAL.NAXIS2"], said["NORMAL.NAXIS3"]));
        Assert.Equal(("x", "sample"), (said["POSITION.PLANE1"], said["CELL.PLANE2"]));
        Assert.Equal(("TOP-DOWN", "-2147483648"), (said["MASK.ROWORDER"], said["TILE.BLANK"]));
        Assert.DoesNotContain("MASK.BLANK", said.Keys);
    }

    [RequiresFact(Part.CFitsio)]
    public void Write_SameFrameTwice_SameBytes() => Assert.Equal(LayerFrame.Fits(), LayerFrame.Fits());

    /// <summary>Memory that an earlier file was in, and that looks like one, is used again.</summary>
    [RequiresFact(Part.CFitsio)]
    public void Write_AfterFilesOfOtherSizes_SameBytes()
    {
        byte[] first = LayerFrame.Fits("all", LayerPrecision.Real32);
        for (int file = 0; file < 20; file++)
        {
            LayerFrame.Fits(file % 2 == 0 ? "all" : "mask,normal");

            Assert.Equal(first, LayerFrame.Fits("all", LayerPrecision.Real32));
        }
    }

    [RequiresFact(Part.CFitsio)]
    public void Write_Compressed_IsSmallerAndTheSameBytesAgain()
    {
        byte[] compressed = LayerFrame.Fits(compression: LayerCompression.Gzip);

        byte[][] together = [.. Enumerable.Range(0, 4).AsParallel().Select(_ => LayerFrame.Fits(compression: LayerCompression.Gzip))];

        Assert.InRange(compressed.Length, 1, 0.8 * LayerFrame.Fits().Length);
        Assert.All(together, file => Assert.Equal(compressed, file));
    }

    [RequiresFact(Part.CFitsio)]
    public void Write_SeveralAtOnce_SameBytesAsOneAlone()
    {
        byte[] alone = LayerFrame.Fits();

        byte[][] together = [.. Enumerable.Range(0, 8).AsParallel().Select(_ => LayerFrame.Fits())];

        Assert.All(together, file => Assert.Equal(alone, file));
    }

    [RequiresFact(Part.CFitsio)]
    public void Write_Cancelled_Stops()
    {
        using CancellationTokenSource source = new();
        source.Cancel();

        Assert.ThrowsAny<OperationCanceledException>(() => FitsLayerWriter.Write(
            Stream.Null, LayerFrame.Metadata, LayerFrame.Provenance, LayerFrame.Truth, LayerSet.OfAnyFrame,
            cancellation: source.Token));
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static string[] Headers(Dictionary<string, string> said) =>
        [.. said.Select(pair => $"{pair.Key}={pair.Value}").Order(StringComparer.Ordinal)];

    private void AssertReadToTheBit(string reader, LayerPrecision precision, LayerCompression compression)
    {
        string[] alwaysDouble = ["position", "latitude", "longitude"]; // docs/formats.md

        LayerFrame.Read(reader, _folder.Write("frame.fits", LayerFrame.Fits("all", precision, compression)), _folder.Path);

        Assert.All(LayerSet.OfAnyFrame.Layers, layer =>
        {
            bool isSingle = precision == LayerPrecision.Real32 && !alwaysDouble.Contains(layer.Name);
            byte[] expected = LayerFrame.ExpectedBytes(layer, isSingle);
            byte[] read = File.ReadAllBytes(_folder[$"{layer.ExtensionName}.bin"]);
            if (compression == LayerCompression.None || layer.Type != LayerType.Real64)
            {
                Assert.Equal(expected, read);
            }
            else
            {
                Assert.Equal(Numbers(expected, isSingle), Numbers(read, isSingle)); // CFITSIO's NaN has other bits
            }
        });
    }

    /// <summary>The bits of numbers, but of any NaN those of one.</summary>
    private static long[] Numbers(byte[] bytes, bool isSingle) => isSingle
        ? [.. MemoryMarshal.Cast<byte, float>(bytes).ToArray().Select(
            x => (long)BitConverter.SingleToInt32Bits(float.IsNaN(x) ? float.NaN : x))]
        : [.. MemoryMarshal.Cast<byte, double>(bytes).ToArray().Select(
            x => BitConverter.DoubleToInt64Bits(double.IsNaN(x) ? double.NaN : x))];
}
