using System.Text;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class PolarLabelTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_PolarLabel_TakesTheProjection()
    {
        LdemLabel label = Read(PolarTestModel.Label);
        Assert.Equal(new PolarStereographic(true, 5000.0, 29.5, 30.5), label.Polar);
        Assert.False(label.CoversWholeMoon);
    }

    [Theory]
    [InlineData("= 5000 <m/pix>", "= 5 <km/pix>")]
    [InlineData("= 5000 <m/pix>", "= 5000 <METERS/PIXEL>")]
    [InlineData("= 5000 <m/pix>", "= 5000")]
    [InlineData("         MAP_RESOLUTION               = 6.0647 <pix/deg>\n", "")]
    public void Read_ScaleInOtherForms_IsTheSame(string from, string to) =>
        Assert.Equal(5000.0, Read(PolarTestModel.Label.Replace(from, to, StringComparison.Ordinal)).Polar!.MetresPerPixel);

    [Fact]
    public void Read_NorthPole_IsNorth() =>
        Assert.False(Read(PolarTestModel.Label
            .Replace("CENTER_LATITUDE              = -90", "CENTER_LATITUDE              = 90", StringComparison.Ordinal)
            .Replace("MAXIMUM_LATITUDE             = -85", "MAXIMUM_LATITUDE             = 90", StringComparison.Ordinal)
            .Replace("MINIMUM_LATITUDE             = -90", "MINIMUM_LATITUDE             = 85", StringComparison.Ordinal)).Polar!.IsSouth);

    [Theory]
    [InlineData("CENTER_LATITUDE              = -90", "CENTER_LATITUDE = -80", "CENTER_LATITUDE = -80 <deg>; a pole, -90 or 90, is needed")]
    [InlineData("CENTER_LATITUDE              = -90 <deg>", "X = 1", "IMAGE_MAP_PROJECTION has no CENTER_LATITUDE")]
    [InlineData("CENTER_LATITUDE              = -90 <deg>", "CENTER_LATITUDE = -90 <rad>", "the unit <deg> is needed")]
    [InlineData(
        "CENTER_LONGITUDE             = 0", "CENTER_LONGITUDE = 180",
        "CENTER_LONGITUDE = 180 <deg>; 0, as LOLA's polar maps have it")]
    [InlineData("CENTER_LONGITUDE             = 0 <deg>", "X = 1", "IMAGE_MAP_PROJECTION has no CENTER_LONGITUDE")]
    [InlineData("MAP_SCALE                    = 5000 <m/pix>", "X = 1", "IMAGE_MAP_PROJECTION has no MAP_SCALE")]
    [InlineData("= 5000 <m/pix>", "= 0 <m/pix>", "MAP_SCALE = 0 <m/pix>; 0.5 to 30400 m a pixel are needed")]
    [InlineData("= 5000 <m/pix>", "= -5000 <m/pix>", "MAP_SCALE = -5000 <m/pix>; 0.5 to 30400 m")]
    [InlineData("= 5000 <m/pix>", "= 5000 <pix/deg>", "MAP_SCALE = 5000 <pix/deg>; the unit <m/pix> is needed")]
    [InlineData("= 5000 <m/pix>", "= 5000 <km/pix>", "MAP_SCALE = 5000 <km/pix>; 0.5 to 30400 m")]
    [InlineData("= 5000 <m/pix>", "= 1E400 <m/pix>", "MAP_SCALE = 1E400 <m/pix>; a finite number is needed")]
    [InlineData("= 5000 <m/pix>", "= \"20\" <m/pix>", "a finite number is needed")]
    [InlineData("= 6.0647 <pix/deg>", "= 7 <pix/deg>", "MAP_RESOLUTION = 7 <pix/deg>; MAP_SCALE = 5000 <m/pix> needs 6.065")]
    [InlineData("= 29.5 <pix>", "= NaN <pix>", "LINE_PROJECTION_OFFSET = NaN <pix>; a finite number is needed")]
    [InlineData("= 29.5 <pix>", "= 29.5 <deg>", "LINE_PROJECTION_OFFSET = 29.5 <deg>; the unit <pix> is needed")]
    [InlineData("= 29.5 <pix>", "= 1e9 <pix>", "LINE_PROJECTION_OFFSET = 1e9 <pix>; the pole's place in the image, px, is needed")]
    [InlineData("= 29.5 <pix>", "= 900 <pix>", "the map reaches farther than 1737.4 km from the pole")]
    [InlineData("= 30.5 <pix>", "= -400 <pix>", "the map reaches farther than 1737.4 km from the pole")]
    [InlineData("SAMPLE_PROJECTION_OFFSET     = 30.5 <pix>", "X = 1", "IMAGE_MAP_PROJECTION has no SAMPLE_PROJECTION_OFFSET")]
    [InlineData("LINE_PROJECTION_OFFSET       = 29.5 <pix>", "X = 1", "IMAGE_MAP_PROJECTION has no LINE_PROJECTION_OFFSET")]
    [InlineData("CENTER_LATITUDE              = -90", "CENTER_LATITUDE = 90", "CENTER_LATITUDE = 90 <deg> needs a latitude of that")]
    [InlineData("= -85 <deg>", "= -80 <deg>", "put the map's sides at -85.06 and its corners at -82.66 degrees")]
    [InlineData("= -85 <deg>", "= -87 <deg>", "put the map's sides at -85.06 and its corners at -82.66 degrees")]
    [InlineData("= -85 <deg>", "= 85 <deg>", "put the map's sides at -85.06 and its corners at -82.66 degrees")]
    [InlineData("LINES                 = 60", "LINES = 1", "LINES = 1; an image of at least 2 x 2 samples is needed")]
    [InlineData("LINES                 = 60", "LINES = 61", "LINE_LAST_PIXEL = 60; the rest of the label needs 61")]
    [InlineData("LINE_SAMPLES          = 64", "LINE_SAMPLES = 63", "SAMPLE_LAST_PIXEL = 64; the rest of the label needs 63")]
    [InlineData("LINE_FIRST_PIXEL             = 1", "LINE_FIRST_PIXEL = 0", "LINE_FIRST_PIXEL = 0; the rest of the label needs 1")]
    [InlineData("SAMPLE_FIRST_PIXEL           = 1", "SAMPLE_FIRST_PIXEL = 2", "SAMPLE_FIRST_PIXEL = 2; the rest of the label needs 1")]
    [InlineData("RECORD_BYTES              = 128", "RECORD_BYTES = 64", "FILE_RECORDS = 60; with RECORD_BYTES = 64 these are 3840 bytes")]
    [InlineData(
        "A_AXIS_RADIUS                = 1737.4", "A_AXIS_RADIUS = 1738.0",
        "A_AXIS_RADIUS = 1738.0 <km>; the heights are over a sphere of 1737400 m")]
    [InlineData("\"EAST\"", "\"WEST\"", "POSITIVE_LONGITUDE_DIRECTION = WEST; EAST is needed")]
    [InlineData(
        "MAP_PROJECTION_ROTATION      = 0.0", "MAP_PROJECTION_ROTATION = 45.0",
        "MAP_PROJECTION_ROTATION = 45.0; the rest of the label needs 0")]
    [InlineData(
        "MEAN EARTH/POLAR AXIS OF DE421", "PRINCIPAL AXES",
        "COORDINATE_SYSTEM_NAME = PRINCIPAL AXES; the MEAN EARTH/POLAR AXIS frame")]
    [InlineData("= MOON", "= MARS", "MAP_PROJECTION_TYPE = POLAR STEREOGRAPHIC; SIMPLE CYLINDRICAL is needed for other bodies")]
    [InlineData("= 16\n", "= 8\n", "SAMPLE_TYPE = LSB_INTEGER; with SAMPLE_BITS = 8 it is not known")]
    [InlineData(
        "POLAR STEREOGRAPHIC", "POLAR STEREO",
        "MAP_PROJECTION_TYPE = POLAR STEREO; SIMPLE CYLINDRICAL or POLAR STEREOGRAPHIC is needed")]
    public void Read_WrongValue_IsRefusedInOneLine(string from, string to, string message)
    {
        string text = PolarTestModel.Label.Replace(from, to, StringComparison.Ordinal);
        Assert.NotEqual(PolarTestModel.Label, text);
        BadInputException exception = Assert.Throws<BadInputException>(() => Read(text));
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', exception.Message);
    }

    [Fact]
    public void Open_Map_ReadsTheSamplesOfItsLines()
    {
        using LdemMapImage image = Open(PolarTestModel.Write(_folder.Path));
        double[] radii = new double[10];
        image.ReadRadii(59, 54, radii);
        Assert.Equal(
            Enumerable.Range(54, 10).Select(sample => 1_737_400.0 + (0.5 * PolarTestModel.ValueAt(59, sample))), radii);
        Assert.Equal((1_735_400.0, 1_739_400.0), image.RadiusLimits);
        Assert.Throws<ArgumentOutOfRangeException>(() => image.ReadRadii(59, 55, radii));
        Assert.Throws<ArgumentOutOfRangeException>(() => image.ReadRadii(60, 0, radii));
    }

    [Theory]
    [InlineData(100, "100 bytes, 7680 expected (60 lines of 128 bytes by ")]
    [InlineData(7681, "7681 bytes, 7680 expected")]
    public void Open_ImageOfWrongLength_IsRefused(int bytes, string message)
    {
        string label = PolarTestModel.Write(_folder.Path);
        File.WriteAllBytes(Path.ChangeExtension(label, ".IMG"), new byte[bytes]);
        BadInputException exception = Assert.Throws<BadInputException>(() => Open(label));
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_MissingImage_IsRefused()
    {
        string label = PolarTestModel.Write(_folder.Path);
        File.Delete(Path.ChangeExtension(label, ".IMG"));
        Assert.Contains(
            "missing; ",
            Assert.Throws<BadInputException>(() => Open(label)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void ReadRadii_SampleOutsideTheLimits_NamesItsPlace()
    {
        string label = PolarTestModel.Write(_folder.Path, PolarTestModel.Label.Replace("= 4000\n", "= 3000\n", StringComparison.Ordinal));
        using LdemMapImage image = Open(label);
        BadInputException exception = Assert.Throws<BadInputException>(() => image.RadiusBounds(0, 60, 0, 64));
        Assert.Contains("LDEM_85S_5000M.IMG, line ", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Find_FolderWithAMap_PassesItBy()
    {
        string label = PolarTestModel.Write(_folder.Path);
        Assert.Null(LdemCatalog.TryFind(4, _folder.Path, []));
        Assert.NotNull(LdemCatalog.TryReadMap(label));
        Assert.NotNull(LdemCatalog.TryReadMap(Path.ChangeExtension(label, ".IMG")));
        Assert.Null(LdemCatalog.TryReadMap(_folder.Path));
        Assert.Contains(
            "a map of the surroundings of a pole; a SIMPLE CYLINDRICAL model of the whole Moon is needed here",
            Assert.Throws<BadInputException>(() => LdemCatalog.Read(label)).Message,
            StringComparison.Ordinal);
    }

    private static LdemLabel Read(string text)
    {
        using MemoryStream stream = new(Encoding.Latin1.GetBytes(text));
        return LdemLabelReader.Read(stream, "LDEM_85S_5000M.LBL");
    }

    private static LdemMapImage Open(string label) => LdemMapImage.Open(LdemSet.OfMap(LdemLabelReader.ReadFile(label)));
}
