using Msisf.Adapters.Interop;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>Rasters on other computers, here on this one: whole ones are read, of others it is said what broke.</summary>
public sealed class RemoteRasterTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Read_WholeRemoteFile_HasTheHeightsOfTheFile()
    {
        using RangeServer server = new(File.ReadAllBytes(TestRaster.Write(_folder, "site.tif")), RangeFault.None);
        using GeoTiffGrid grid = GeoTiffGrid.Open(server.Path(), libraryPath: null);
        double[] radii = new double[TestRaster.Samples];
        grid.ReadRadii(TestRaster.Lines - 1, 0, radii);
        for (int sample = 0; sample < radii.Length; sample++)
        {
            Assert.Equal(1_737_400.0 + TestRaster.HeightAt(TestRaster.Lines - 1, sample), radii[sample], 1e-4); // m: heights are floats
        }

        using GdalStream stream = new(server.Path());
        byte[] content = new byte[stream.Length];
        stream.ReadExactly(content);
        Assert.Equal(File.ReadAllBytes(_folder["site.tif"]), content);
    }

    /// <summary>GDAL takes for missing what a server leaves out: an image without a coordinate system, or lines of zeros.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData(RangeFault.Hangs, "GDAL can't open the remote file")]
    [InlineData(RangeFault.BreaksOffInHead, "the remote file")]
    [InlineData(RangeFault.BreaksOff, "The remote file broke off.")]
    [InlineData(RangeFault.SaysTooLittle, "The remote file broke off.")]
    public void Read_BadServer_SaysWhatBroke(RangeFault fault, string expected)
    {
        using RangeServer server = new(File.ReadAllBytes(TestRaster.Write(_folder, "site.tif")), fault);
        string path = server.Path(fault == RangeFault.Hangs ? "?low_speed_time=1&low_speed_limit=1000&max_retry=0&url=" : "/");
        BadInputException error = Assert.Throws<BadInputException>(() =>
        {
            using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
            grid.NoteOfGaps(); // looks at all pixels
        });
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
        Assert.Contains("at least 1000 bytes in a second", error.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', error.Message);
    }

    /// <summary>The pixels are all there, so an image can be drawn; the checksum of the file can't be told.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Read_ServerSaysTooMuch_SaysWhereTheFileEnds()
    {
        byte[] file = File.ReadAllBytes(TestRaster.Write(_folder, "site.tif"));
        using RangeServer server = new(file, RangeFault.SaysTooMuch);
        using GeoTiffGrid grid = GeoTiffGrid.Open(server.Path(), libraryPath: null);
        Assert.Null(grid.NoteOfGaps());
        using GdalStream stream = new(server.Path());
        IOException error = Assert.Throws<IOException>(() => stream.ReadExactly(new byte[stream.Length]));
        Assert.Contains($"broke off after {file.Length} of {2 * file.Length} bytes", error.Message, StringComparison.Ordinal);
    }
}
