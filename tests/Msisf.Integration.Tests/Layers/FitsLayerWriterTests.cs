using System.Globalization;
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
    [InlineData("all")]
    [InlineData("mask")]
    public void Write_Layers_PassFitsverifyWithoutAWarning(string layers)
    {
        string path = _folder.Write("frame.fits", LayerFrame.Fits(layers));

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

    [RequiresFact(Part.CFitsio, Part.Astropy)]
    public void Write_AllLayers_AstropyReadsThemToTheBit() => AssertReadToTheBit("astropy");

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
    public void Write_AllLayers_GdalReadsThemToTheBit() => AssertReadToTheBit("gdal");

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
        Assert.Equal(LayerFrame.Metadata.Camera.PositionMoonMe.Y, Number(said["CAMPOSY"]));
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
            Stream.Null, LayerFrame.Metadata, LayerFrame.Provenance, LayerFrame.Truth, LayerSet.WithoutDetector, source.Token));
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private void AssertReadToTheBit(string reader)
    {
        LayerFrame.Read(reader, _folder.Write("frame.fits", LayerFrame.Fits()), _folder.Path);

        Assert.All(
            LayerSet.WithoutDetector.Layers,
            layer => Assert.Equal(LayerFrame.ExpectedBytes(layer), File.ReadAllBytes(_folder[$"{layer.ExtensionName}.bin"])));
    }
}
