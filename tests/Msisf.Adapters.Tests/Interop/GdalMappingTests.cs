using Msisf.Adapters.Interop;
using Msisf.Adapters.Tests.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Interop;

/// <summary>What is mapped into memory is what GDAL reads; what can't be mapped is read by GDAL.</summary>
public sealed class GdalMappingTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("GTiff", "pass", true)]
    [InlineData("GTiff", "kind = gdal.GDT_Int16; nodata = 545", true)]
    [InlineData("GTiff", "nodata = 545", true)]
    [InlineData("ENVI", "kind = gdal.GDT_Int16", true)]
    [InlineData("ISIS3", "pass", true)]
    [InlineData("GTiff", "kind = gdal.GDT_Float64", false)]
    [InlineData("GTiff", "kind = gdal.GDT_UInt16", false)]
    [InlineData("GTiff", "kind = gdal.GDT_Int16; options = ['ENDIANNESS=BIG']", false)]
    [InlineData("GTiff", "options = ['COMPRESS=DEFLATE']", false)]
    [InlineData("GTiff", "options = ['TILED=YES']", false)]
    public void Read_AnyWindow_HasTheStoredValues(string driver, string then, bool isMapped)
    {
        bool isWhole = then.Contains("Int", StringComparison.Ordinal);
        string path = TestRaster.Write(_folder, driver == "ISIS3" ? "raster.cub" : "raster.tif", then, driver);
        using GdalImage image = GdalImage.Open(path, libraryPath: null);
        Assert.Equal(isMapped, image.IsMapped);
        Random random = new(7);
        for (int i = 0; i < 40; i++)
        {
            (int lines, int samples) = (random.Next(1, 20), random.Next(1, 50));
            (int line, int sample) = (random.Next(TestRaster.Lines - lines + 1), random.Next(TestRaster.Samples - samples + 1));
            int stride = samples + random.Next(3);
            float[] values = new float[lines * stride];
            image.Read(line, lines, sample, samples, values, stride);
            for (int place = 0; place < values.Length; place++)
            {
                (int row, int column) = (place / stride, place % stride);
                double height = TestRaster.HeightAt(line + row, sample + column);
                float stored = (float)(isWhole ? Math.Floor(height + 0.5) : height);
                Assert.Equal(column >= samples ? 0.0F : stored == image.NoData ? float.NaN : stored, values[place]);
            }
        }
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_FileThatEndsEarly_IsReadByGdalWhichSaysSo()
    {
        string path = TestRaster.Write(_folder, "raster.tif");
        using (FileStream file = File.OpenWrite(path))
        {
            file.SetLength(file.Length - 100_000);
        }

        using GdalImage image = GdalImage.Open(path, libraryPath: null);
        Assert.False(image.IsMapped);
        BadInputException failure = Assert.Throws<BadInputException>(
            () => image.Read(0, TestRaster.Lines, 0, TestRaster.Samples, new float[TestRaster.Lines * TestRaster.Samples]));
        Assert.Contains("GDAL can't read it to its end", failure.Message, StringComparison.Ordinal);
    }
}
