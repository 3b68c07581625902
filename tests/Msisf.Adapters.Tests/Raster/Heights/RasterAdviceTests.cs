using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>What errors advise is done with the file that caused the error; then it is read.</summary>
public sealed partial class RasterAdviceTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The command is that of the message, with the words in capitals replaced by the map's borders.</summary>
    /// <param name="then">What the file has.</param>
    /// <param name="arguments">Arguments that the message leaves to the user.</param>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("s = ''; t = [0, 1, 0, 0, 0, 1]", "has no coordinate system", "")]
    [InlineData("s += ' +towgs84=1,0,0,0,0,0,0'", "has +towgs84=1,0,0,0,0,0,0", "")]
    [InlineData("s = '+proj=stere +lat_0=-90 +datum=WGS84'", "is not one on a sphere", "+proj=stere +lat_0=-90 +R=1737400 +units=m")]
    [InlineData("t = [177000, 5, 0, -1900, 0, 5]", "has no place on the map", "-t_srs +proj=stere +lat_0=-90 +R=1737400")]
    [InlineData("t = [177000, 5, 0.5, -500, 0.5, -5]", "has no place on the map", "-t_srs +proj=stere +lat_0=-90 +R=1737400")]
    public void Open_WrongSystem_IsReadAsAdvised(string then, string reason, string arguments)
    {
        string path = TestRaster.Write(_folder, "site.tif", then);
        string message = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message;
        Assert.Contains(reason, message, StringComparison.Ordinal);
        Match command = Command().Match(message);
        Assert.True(command.Success, message);

        string words = command.Groups["arguments"].Value.Replace("WEST NORTH EAST SOUTH", "30 20.28 30.3 20", StringComparison.Ordinal);
        string[] quoted = [.. Words().Matches(words).Select(word => word.Value.Trim('\''))];
        string[] more = arguments.StartsWith("-t_srs ", StringComparison.Ordinal) ? ["-t_srs", arguments["-t_srs ".Length..]]
            : arguments.Length > 0 ? [arguments] : [];
        ChildRun.Of(command.Groups["program"].Value, ["-q", .. quoted, .. more, path, _folder["new.tif"]], _folder.Path).Succeeded();

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);
        (double[] radius, bool[] gap) = (new double[1], new bool[1]);
        (int line, int sample) = (grid.Window.FirstLine + (grid.Window.Lines / 2), grid.Window.FirstSample + (grid.Window.Samples / 2));
        grid.ReadGaps(line, sample, gap);
        Assert.False(gap[0]);
        grid.ReadRadii(line, sample, radius);
        double middle = 1_737_400.0 + TestRaster.HeightAt(TestRaster.Lines / 2, TestRaster.Samples / 2);
        Assert.InRange(radius[0], middle - 25.0, middle + 25.0); // the file's slopes over some pixels
    }

    /// <summary>Longitudes to the west, or from another meridian: the advised coordinate system is written into the file.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("+axis=wnu")]
    [InlineData("+pm=paris")]
    public void Open_LongitudesOfAnotherKind_AreReadAsAdvised(string part)
    {
        const string Degrees = "s, t = '+proj=longlat +R=1737400', [30, 0.001, 0, 20.28, 0, -0.001]";
        string path = TestRaster.Write(_folder, "site.tif", Degrees);
        string message = Assert.Throws<BadInputException>(() => GeoTiffPlacement.Find(
            path, 300, 280, [30.0, 0.001, 0.0, 20.28, 0.0, -0.001], $"+proj=longlat +R=1737400 {part}")).Message;
        Match command = Command().Match(message);
        Assert.Contains(part, message, StringComparison.Ordinal);
        string[] words = [.. Words().Matches(command.Groups["arguments"].Value).Select(word => word.Value.Trim('\''))];
        ChildRun.Of(command.Groups["program"].Value, ["-q", .. words, path, _folder["new.tif"]], _folder.Path).Succeeded();

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);

        Assert.Equal((69_720, 30_000), (grid.Window.FirstLine, grid.Window.FirstSample));
    }

    /// <summary>Pixels too small for the grid: in degrees, in a projection that is resampled, and about a site.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("s = '+proj=longlat +R=1737400'; t = [30, 1e-5, 0, 20.001, 0, -1e-5]")]
    [InlineData("s = '+proj=ortho +lat_0=20 +lon_0=30 +R=1737400'; t = [-30, 0.2, 0, 30, 0, -0.2]")]
    [InlineData("s = '+proj=eqc +lat_ts=20 +lon_0=30 +R=1737400'; t = [0, 0.3, 0, 606500, 0, -0.3]")]
    public void Open_SmallPixels_AreReadAsAdvised(string then)
    {
        string path = TestRaster.Write(_folder, "site.tif", then + "; a = 500 + 0.01 * line");
        string message = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message;
        Assert.Contains("are smaller than 0.5 m, or lie nowhere on the Moon. If they are small, make them larger: ", message);
        string[] words = [.. Words().Matches(message.Split("larger: gdalwarp ")[1].Split(" (")[0]).Select(word => word.Value.Trim('\''))];
        ChildRun.Of("gdalwarp", ["-q", .. words, "-dstnodata", "-9999", path, _folder["new.tif"]], _folder.Path).Succeeded();

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);
        double[] radius = new double[1];
        grid.ReadRadii(grid.Window.FirstLine + (grid.Window.Lines / 2), grid.Window.FirstSample + (grid.Window.Samples / 2), radius);
        Assert.Equal(1_737_400.0 + 500.0 + (0.01 * TestRaster.Lines / 2.0), radius[0], 0.05);
        Assert.Equal(50_000, grid.Projection.Resolution.PixelsPerDegree);
    }

    /// <summary>A band whose numbers all mean the same height gets the factor and the offset of the message.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_ScaleOfZero_IsReadAsAdvised()
    {
        string path = TestRaster.Write(_folder, "site.tif", "scale, offset = 0.0, 5.0");
        Match command = Scale().Match(Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message);
        ChildRun.Of("gdal_translate", ["-q", .. command.Value.Split(' ')[1..], path, _folder["new.tif"]], _folder.Path).Succeeded();

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);
        double[] radius = new double[1];
        grid.ReadRadii(grid.Window.FirstLine + 77, grid.Window.FirstSample + 131, radius);
        Assert.Equal(1_737_400.0 + TestRaster.HeightAt(77, 131), radius[0], 1e-3); // m: the file's floats
    }

    /// <summary>Heights in units that are not read, or not even known: the advised option makes metres of them.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("ft", 0.3048)]
    [InlineData("US survey foot", 0.3048006096)]
    [InlineData("fathom", 1.8288)]
    public void Open_OtherUnit_IsReadAsAdvised(string unit, double metres)
    {
        string path = TestRaster.Write(_folder, "site.tif", FormattableString.Invariant($"a /= {metres:R}; unit = '{unit}'"));
        string message = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message;
        string option = Option().Match(message).Groups[1].Value.Replace(
            "METRES", metres.ToString("R", System.Globalization.CultureInfo.InvariantCulture), StringComparison.Ordinal);

        using GeoTiffGrid grid = GeoTiffGrid.Open(
            path, libraryPath: null,
            new HeightOptions(double.Parse(option, System.Globalization.CultureInfo.InvariantCulture), Offset: null));
        double[] radius = new double[1];
        grid.ReadRadii(grid.Window.FirstLine + 77, grid.Window.FirstSample + 131, radius);
        Assert.Equal(1_737_400.0 + TestRaster.HeightAt(77, 131), radius[0], 1e-3); // m: the file's floats
    }

    /// <summary>GDAL ignores the direction of longitudes in a PDS3 label; with the two advised values it places the map right.</summary>
    [RequiresTheory(Part.GdalLibrary)]
    [InlineData(300.0, 60.0)]
    [InlineData(-20.0, 20.0)]
    public void Open_PdsMapWithWestLongitudes_IsReadAsAdvised(double west, double expectedMiddle)
    {
        string label = PdsLabel("WEST", west);
        File.WriteAllBytes(_folder["MAP.IMG"], [.. Enumerable.Range(0, 40 * 40).SelectMany(i => BitConverter.GetBytes((short)i))]);
        string path = _folder.Write("MAP.LBL", label);
        string message = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message;
        Assert.Contains("POSITIVE_LONGITUDE_DIRECTION = WEST; GDAL takes longitudes as east", message, StringComparison.Ordinal);
        foreach (Match advised in Keyword().Matches(message[message.IndexOf("Write ", StringComparison.Ordinal)..]))
        {
            label = Regex.Replace(label, $"{advised.Groups[1].Value} = [^\n]*", advised.Value);
        }

        _folder.Write("MAP.LBL", label);
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);

        // The map begins 20 samples of a quarter degree west of its middle.
        Assert.Equal((4.0 * expectedMiddle) - 20.0, grid.Window.FirstSample);
    }

    /// <summary>Where both directions mean the same place nothing is to be done.</summary>
    [RequiresTheory(Part.GdalLibrary)]
    [InlineData("WEST", 0.0)]
    [InlineData("WEST", 180.0)]
    [InlineData("EAST", 300.0)]
    public void Open_PdsMapWhoseMiddleIsTheSame_IsRead(string direction, double middle)
    {
        File.WriteAllBytes(_folder["MAP.IMG"], new byte[40 * 40 * 2]);

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder.Write("MAP.LBL", PdsLabel(direction, middle)), libraryPath: null);

        Assert.Equal(((4.0 * middle) + 1440.0 - 20.0) % 1440.0, grid.Window.FirstSample);
    }

    /// <summary>A map of 10 x 10 degrees, 4 px a degree, about a point of the equator; not of LOLA, so GDAL reads it.</summary>
    private static string PdsLabel(string direction, double middle) => FormattableString.Invariant(
        $$"""
        PDS_VERSION_ID = PDS3
        ^IMAGE = "MAP.IMG"
        RECORD_BYTES = 80
        DATA_SET_ID = "OTHER"
        PRODUCT_ID = "MAP"
        TARGET_NAME = MOON
        OBJECT = IMAGE
        LINES = 40
        LINE_SAMPLES = 40
        SAMPLE_TYPE = LSB_INTEGER
        SAMPLE_BITS = 16
        UNIT = METER
        END_OBJECT = IMAGE
        OBJECT = IMAGE_MAP_PROJECTION
        MAP_PROJECTION_TYPE = "SIMPLE CYLINDRICAL"
        MAP_RESOLUTION = 4 <pix/deg>
        MAP_SCALE = 7580.8376059 <m/pix>
        A_AXIS_RADIUS = 1737.4 <km>
        B_AXIS_RADIUS = 1737.4 <km>
        C_AXIS_RADIUS = 1737.4 <km>
        POSITIVE_LONGITUDE_DIRECTION = {{direction}}
        CENTER_LATITUDE = 0 <deg>
        CENTER_LONGITUDE = {{middle}} <deg>
        LINE_PROJECTION_OFFSET = 19.5 <pix>
        SAMPLE_PROJECTION_OFFSET = 19.5 <pix>
        END_OBJECT = IMAGE_MAP_PROJECTION
        END
        """);

    /// <summary>A hole is filled, or cut off, by the programs that the message names.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("gdal_fillnodata.py", "")]
    [InlineData("gdal_translate -srcwin", "-srcwin 0 0 300 100")]
    public void Read_Hole_IsGoneAsAdvised(string advice, string arguments)
    {
        string path = TestRaster.Write(_folder, "site.tif", "a[120:124, 150:153] = -9999; nodata = -9999");
        using (GeoTiffGrid holed = GeoTiffGrid.Open(path, libraryPath: null))
        {
            Assert.True(holed.MayHaveGaps);
            string message = Assert.Throws<BadInputException>(
                () => holed.ReadRadii(holed.Window.FirstLine + 121, holed.Window.FirstSample + 151, new double[1])).Message;
            Assert.Contains(advice, message, StringComparison.Ordinal);
        }

        ChildRun.Of(
            advice.Split(' ')[0], ["-q", .. arguments.Split(' ', StringSplitOptions.RemoveEmptyEntries), path, _folder["new.tif"]],
            _folder.Path).Succeeded();

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);
        bool[] gaps = new bool[grid.Window.Samples];
        double[] radii = new double[grid.Window.Samples];
        for (int line = grid.Window.FirstLine; line < grid.Window.EndLine; line++)
        {
            grid.ReadGaps(line, grid.Window.FirstSample, gaps);
            Assert.DoesNotContain(true, gaps);
            grid.ReadRadii(line, grid.Window.FirstSample, radii);
        }
    }

    [GeneratedRegex("(?<program>gdal_translate|gdalwarp)(?<arguments>( '[^']*'| -?[A-Za-z_]+(?=[ .;]))*)")]
    private static partial Regex Command();

    [GeneratedRegex("gdal_translate -a_scale [0-9]+ -a_offset [0-9]+")]
    private static partial Regex Scale();

    [GeneratedRegex(",scale=([0-9.]*[0-9]|METRES)")]
    private static partial Regex Option();

    [GeneratedRegex("([A-Z_]+) = ([A-Z]+|[0-9.]*[0-9])")]
    private static partial Regex Keyword();

    [GeneratedRegex("'[^']*'|[^ ']+")]
    private static partial Regex Words();
}
