using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>How fine a map is that has to be warped.</summary>
public sealed class RasterWarpTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>There are 30,323.3 pixels of 1 m a degree; there are levels of detail, and the middle has the height of the file.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_MapOf1MetreFarFromThePoles_IsRead()
    {
        using GeoTiffGrid grid = Open(
            "s = '+proj=ortho +lat_0=20 +lon_0=30 +R=1737400'; t = [-150, 1, 0, 140, 0, -1]; a = 500 + 0.25 * line");
        Equirectangular cylinder = Assert.IsType<Equirectangular>(grid.Projection);
        Assert.InRange(cylinder.PixelsPerDegree, 30_324, 30_324 * 65 / 64);
        Assert.InRange(MapLevels.Open(grid).Count, 4, 5);
        (double line, double sample) = grid.Projection.PixelOf(
            new SelenographicPoint(double.DegreesToRadians(20.0), double.DegreesToRadians(30.0)).ToDirectionBodyFixed());
        double[] radius = new double[1];
        grid.ReadRadii((int)Math.Round(line), (int)Math.Round(sample), radius);
        Assert.Equal(1_737_400.0 + 500.0 + (0.25 * 139.5), radius[0], 0.15); // within half a pixel
    }

    /// <summary>Away from the poles, and near one.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData(20, "[-750, 5, 0, 1400, 0, -10]")]
    [InlineData(20, "[-1500, 10, 0, 700, 0, -5]")]
    [InlineData(-80, "[-750, 5, 0, 1400, 0, -10]")]
    [InlineData(-80, "[-1500, 10, 0, 700, 0, -5]")]
    public void Open_OblongPixels_StayAsFineAsTheirFinerSide(int latitude, string transform)
    {
        using GeoTiffGrid grid = Open($"s = '+proj=ortho +lat_0={latitude} +lon_0=30 +R=1737400'; t = {transform}");
        Assert.InRange(grid.Projection.Resolution.MetresPerPixel, 4.9, 5.0000001);
    }

    private GeoTiffGrid Open(string then) => GeoTiffGrid.Open(TestRaster.Write(_folder, "site.tif", then), libraryPath: null);
}
