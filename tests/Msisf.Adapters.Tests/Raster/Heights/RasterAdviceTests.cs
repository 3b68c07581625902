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

    [GeneratedRegex("'[^']*'|[^ ']+")]
    private static partial Regex Words();
}
