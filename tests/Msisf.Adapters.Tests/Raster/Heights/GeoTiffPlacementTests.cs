using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class GeoTiffPlacementTests
{
    private const string South = "+proj=stere +lat_0=-90 +lon_0=0 +k=1 +x_0=0 +y_0=0 +R=1737400 +units=m +no_defs";
    private const string Degrees = "+proj=longlat +R=1737400 +no_defs";
    private static readonly double[] Piece = [177000.0, 5.0, 0.0, -500.0, 0.0, -5.0];
    private static readonly double[] Band = [-180.0, 0.25, 0.0, 60.0, 0.0, -0.25];

    /// <summary>NPB_final_adj_5mpp_surf_piece_1km_2_12.tif: its centre is at 90d19'22.04"E, 84d 9' 5.10"S (gdalinfo).</summary>
    [Fact]
    public void Of_PolarPiece_HasTheCentreOfGdalinfo()
    {
        GeoTiffPlacement placement = Of("a.tif", 200, 200, Piece, South);
        SelenographicPoint centre = SelenographicPoint.Below(placement.Projection.DirectionOf(99.5, 99.5));
        Assert.Equal(-(84.0 + (9.0 / 60.0) + (5.10 / 3600.0)), double.RadiansToDegrees(centre.Latitude), 2e-6);
        Assert.Equal(90.0 + (19.0 / 60.0) + (22.04 / 3600.0), double.RadiansToDegrees(centre.Longitude), 2e-6);
        Assert.Equal(1_737_400.0, placement.SphereRadius);
    }

    /// <summary>On a sphere of 1738 km a direction lies 1738 / 1737.4 times as far from the pole.</summary>
    [Theory]
    [InlineData("+R=1737400", "+R=1738000", 5.0 * 1737.4 / 1738.0)]
    [InlineData("+R=1737400", "+a=1737400 +b=1737400", 5.0)]
    [InlineData("+k=1", "+k=0.994", 5.0 / 0.994)]
    [InlineData("+k=1", "+lat_ts=-90", 5.0)]
    [InlineData("+k=1", "+lat_ts=-30", 5.0 / 0.75)]
    public void Of_OtherSphereOrScale_ChangesTheScale(string from, string to, double scale)
    {
        PolarStereographic map = Assert.IsType<PolarStereographic>(
            Of("a.tif", 200, 200, Piece, South.Replace(from, to, StringComparison.Ordinal)).Projection);
        Assert.Equal(scale, map.MetresPerPixel, Rounding.OfPlaces);
        Assert.Equal((-100.5, -35400.5), (Math.Round(map.LineOffset, 6), Math.Round(map.SampleOffset, 6)));
    }

    [Fact]
    public void Of_FalseOrigin_MovesThePole()
    {
        PolarStereographic map = Assert.IsType<PolarStereographic>(Of(
            "a.tif", 200, 200, Piece, South.Replace("+x_0=0 +y_0=0", "+x_0=200000 +y_0=500", StringComparison.Ordinal)).Projection);
        Assert.Equal((-200.5, 4599.5), (map.LineOffset, map.SampleOffset));
    }

    [Theory]
    [InlineData(Degrees, 1440, 480, 120, 0, 720)]
    [InlineData("+proj=longlat +a=1737400 +b=1737400 +lon_0=0", 1440, 480, 120, 0, 720)]
    public void Of_BandAllAround_IsARing(string projection, int width, int height, int line, int sample, int ringStart)
    {
        GeoTiffPlacement placement = Of("a.tif", width, height, Band, projection);
        Assert.Equal(new Equirectangular(4), placement.Projection);
        Assert.Equal(new GridWindow(line, line + height, sample, sample + width), placement.Window);
        Assert.Equal(ringStart, placement.RingStart);
    }

    [Theory]
    [InlineData(-180.0, 720)]
    [InlineData(0.0, 0)]
    [InlineData(100.5, 402)]
    public void Of_WholeMoon_IsARingFromAnyLongitude(double west, int ringStart)
    {
        GeoTiffPlacement placement = Of("a.tif", 1440, 720, [west, 0.25, 0.0, 90.0, 0.0, -0.25], Degrees);
        Assert.Equal(new GridWindow(0, 720, 0, 1440), placement.Window);
        Assert.Equal((true, ringStart), (placement.IsRing, placement.RingStart));
        Assert.Equal((0, 1439), (placement.ColumnOf(ringStart), placement.ColumnOf((ringStart + 1439) % 1440)));
    }

    /// <summary>A US survey foot has 1200 / 3937 m.</summary>
    [Theory]
    [InlineData("+units=us-ft", 5.0 * 1200.0 / 3937.0)]
    [InlineData("+units=ft", 1.524)]
    [InlineData("+to_meter=2", 10.0)]
    [InlineData("+units=m +towgs84=0,0,0,0,0,0,0", 5.0)]
    public void Of_OtherUnitOrBoundSystem_HasItsScale(string words, double scale) => Assert.Equal(
        scale,
        Assert.IsType<PolarStereographic>(
            Of("a.tif", 200, 200, Piece, South.Replace("+units=m", words, StringComparison.Ordinal)).Projection).MetresPerPixel,
        Rounding.OfPlaces);

    /// <summary>A prime meridian 10 degrees east of the Moon's moves a map by as much.</summary>
    [Fact]
    public void Of_PrimeMeridian_MovesTheMap() => Assert.Equal(
        new GridWindow(120, 600, 40, 140),
        Of("a.tif", 100, 480, [0.0, 0.25, 0.0, 60.0, 0.0, -0.25], "+proj=longlat +R=1737400 +pm=10").Window);

    /// <summary>The same map in metres and in kilometres, with its origin moved by whole pixels; PROJ's x_0 and y_0 are metres.</summary>
    [Theory]
    [InlineData("+units=m", 1.0)]
    [InlineData("+units=km", 1000.0)]
    [InlineData("+to_meter=2", 2.0)]
    public void Of_FalseEastingInAnyUnit_IsTheSamePlace(string units, double metres)
    {
        double pixel = 1_737_400.0 * Math.PI / 180.0 / 4.0;
        (double east, double north) = (100.0 * pixel, -60.0 * pixel);
        double[] transform = [.. ((double[])[(40.0 * pixel) + east, pixel, 0.0, (240.0 * pixel) + north, 0.0, -pixel])
            .Select(number => number / metres)];

        Assert.Equal(
            new GridWindow(120, 600, 40, 140),
            Of(
                "a.tif", 100, 480, transform,
                FormattableString.Invariant($"+proj=eqc +R=1737400 +x_0={east:R} +y_0={north:R} {units}")).Window);
    }

    /// <summary>Labels of PDS3 round the size of a pixel; its place in pixels from the origin they do not.</summary>
    [Fact]
    public void Of_RoundedScale_IsTheWholeNumberOfPixels()
    {
        // 12 degrees north and east of the origin at 4096 px/deg, 7.4031617 m written with four digits.
        const double Edge = 12.0 * 4096.0 * 7.403;
        GeoTiffPlacement placement = GeoTiffPlacement.Find(
            "a.lbl", 12288, 12288, [Edge, 7.403, 0.0, Edge, 0.0, -7.403], "+proj=eqc +R=1737400", hasRoundedScale: true)!;
        Assert.Equal(new GridWindow(78 * 4096, 81 * 4096, 12 * 4096, 15 * 4096), placement.Window);
        Assert.Null(GeoTiffPlacement.Find(
            "a.tif", 12288, 12288, [Edge, 7.403, 0.0, Edge, 0.0, -7.403], "+proj=eqc +R=1737400"));
    }

    /// <summary>Samples count on beyond 360 degrees.</summary>
    [Fact]
    public void Of_MapAcrossThePrimeMeridian_CountsOn()
    {
        GeoTiffPlacement placement = Of("a.tif", 100, 480, [-10.0, 0.25, 0.0, 60.0, 0.0, -0.25], Degrees);
        Assert.Equal(new GridWindow(120, 600, 1400, 1500), placement.Window);
        SelenographicPoint last = SelenographicPoint.Below(placement.Projection.DirectionOf(120, 1499));
        Assert.Equal(15.0 - 0.125, double.RadiansToDegrees(last.Longitude), Rounding.OfChains);
        Assert.Equal(60.0 - 0.125, double.RadiansToDegrees(last.Latitude), Rounding.OfChains);
    }

    [Fact]
    public void Of_EquirectangularMetres_AreDegrees()
    {
        double pixel = 1_737_400.0 * Math.PI / 180.0 / 16.0;
        GeoTiffPlacement placement = Of(
            "a.tif", 100, 50, [-20.0 * 16.0 * pixel, pixel, 0.0, 10.0 * 16.0 * pixel, 0.0, -pixel],
            "+proj=eqc +lat_ts=0 +lat_0=0 +lon_0=180 +x_0=0 +y_0=0 +R=1737400 +units=m");
        Assert.Equal(new Equirectangular(16), placement.Projection);
        Assert.Equal(new GridWindow(1280, 1330, 2560, 2660), placement.Window);
    }

    [Theory]
    [InlineData(null, "has no coordinate system")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +ellps=WGS84 +units=m", "is not one on a sphere of the Moon")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +datum=WGS84 +units=m", "is not one on a sphere of the Moon")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +R=6371000 +units=m", "is not one on a sphere of the Moon")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +a=1738100 +b=1736000 +units=m", "is not one on a sphere of the Moon")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +R=2439700 +units=m", "is not one on a sphere of the Moon")]
    [InlineData("+proj=stere +lat_0=-90 +R=1737400 +towgs84=1,0,0,0,0,0,0", "has +towgs84=1,0,0,0,0,0,0, which is not read")]
    [InlineData("+proj=longlat +R=1737400 +axis=wnu", "gdal_translate -a_srs '+proj=longlat +R=1737400'")]
    [InlineData("+proj=longlat +R=1737400 +pm=paris", "has +pm=paris, which is not read")]
    [InlineData("+proj=longlat +R=1737400 +nadgrids=moon.gsb", "has +nadgrids=moon.gsb, which is not read")]
    [InlineData("+proj=longlat +R=1737400 +angular_unit=0.0157", "has +angular_unit=0.0157, which is not read")]
    [InlineData("", "is not one on a sphere of the Moon")]
    public void Of_WrongSystem_IsRefusedInOneLine(string? projection, string message) =>
        AssertRefused(200, 200, Piece, projection, message);

    [Theory]
    [InlineData("177000 5 0 -500 0 5", "has no place on the map")]
    [InlineData("177000 5 0.1 -500 0 -5", "has no place on the map")]
    [InlineData("177000 -5 0 -500 0 -5", "has no place on the map")]
    [InlineData("177000 NaN 0 -500 0 -5", "has no place on the map")]
    [InlineData("177000 0.1 0 -500 0 -0.1", "0.5 to 30400 m are read")]
    [InlineData("2E6 5 0 -500 0 -5", "a map that reaches farther than 1737.4 km")]
    [InlineData("Infinity 5 0 -500 0 -5", "a map that reaches farther than 1737.4 km")]
    public void Of_WrongPlace_IsRefusedInOneLine(string transform, string message) => AssertRefused(
        200, 200,
        [.. transform.Split(' ').Select(number => double.Parse(number, System.Globalization.CultureInfo.InvariantCulture))],
        South, message);

    /// <summary>On no grid that is read: such a map is resampled.</summary>
    [Theory]
    [InlineData("+proj=stere +lat_0=-80 +lon_0=0 +R=1737400 +units=m")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=30 +R=1737400 +units=m")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +pm=10 +R=1737400 +units=m")]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +R=1737400 +units=fathom")]
    [InlineData("+proj=ortho +lat_0=-90 +lon_0=0 +R=1737400 +units=m")]
    [InlineData("+proj=eqc +lat_ts=0 +lat_0=0 +lon_0=0 +R=1737400 +units=m")]
    public void Find_OtherSystem_IsOnNoGrid(string projection) =>
        Assert.Null(GeoTiffPlacement.Find("a.tif", 200, 200, Piece, projection));

    [Theory]
    [InlineData(1440, 480, 0.25, 60.1, -180.0)] // between the lines
    [InlineData(100, 480, 0.3, 60.0, 10.0)] // no whole number a degree
    [InlineData(100, 800, 0.25, 60.0, 10.0)] // beyond the pole
    public void Find_CylindricalMapBetweenSamples_IsOnNoGrid(int width, int height, double pixel, double north, double west) =>
        Assert.Null(GeoTiffPlacement.Find("a.tif", width, height, [west, pixel, 0.0, north, 0.0, -pixel], Degrees));

    [Fact]
    public void Find_PolarPixelsThatAreNotSquare_AreOnNoGrid() =>
        Assert.Null(GeoTiffPlacement.Find("a.tif", 200, 200, [177_000.0, 5.0, 0.0, -500.0, 0.0, -6.0], South));

    [Fact]
    public void Of_OneColumn_IsRefused() => AssertRefused(1, 480, [10.0, 0.25, 0.0, 60.0, 0.0, -0.25], Degrees, "less than 2 x 2");

    [Fact]
    public void Of_NoTransform_IsRefused() => AssertRefused(200, 200, null, South, "has no place on the map");

    /// <summary>The placement on a grid that is read.</summary>
    private static GeoTiffPlacement Of(string path, int width, int height, double[]? transform, string? projection) =>
        GeoTiffPlacement.Find(path, width, height, transform, projection)!;

    private static void AssertRefused(int width, int height, double[]? transform, string? projection, string message)
    {
        BadInputException exception = Assert.Throws<BadInputException>(
            () => Of("a.tif", width, height, transform, projection));
        Assert.StartsWith("a.tif: ", exception.Message, StringComparison.Ordinal);
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', exception.Message);
    }
}
