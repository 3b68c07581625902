using System.Text;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public class LdemLabelReaderTests
{
    [RequiresFact(Part.Ldem4)]
    public void ReadFile_RealLdem4_TakesAllFromTheLabel()
    {
        LdemLabel label = LdemLabelReader.ReadFile(TestParts.Ldem4Label!);

        Assert.Equal("LDEM_4", label.ProductId);
        Assert.Equal((4, 720, 1440), (label.PixelsPerDegree, label.Lines, label.LineSamples));
        Assert.Equal(LdemSampleType.Int16LittleEndian, label.SampleType);
        Assert.Equal((0.5, 1737400.0, -17758.0, 21008.0), (label.ScalingFactor, label.Offset, label.Minimum, label.Maximum));
        Assert.Equal("LDEM_4.IMG", Path.GetFileName(label.ImagePath));
        Assert.Equal((0L, 2073600L), (label.ImageOffset, label.FileBytes));
        Assert.Equal("MEAN EARTH/POLAR AXIS OF DE421", label.CoordinateSystem);
        Assert.True(label.CoversWholeMoon);
    }

    [Theory]
    [InlineData("MSB_INTEGER", LdemSampleType.Int16BigEndian)]
    [InlineData("LSB_INTEGER", LdemSampleType.Int16LittleEndian)]
    [InlineData("SUN_INTEGER", LdemSampleType.Int16BigEndian)]
    [InlineData("\"VAX INTEGER\"", LdemSampleType.Int16LittleEndian)]
    public void Read_IntegerTypes_AreKnown(string sampleType, LdemSampleType expected) =>
        Assert.Equal(expected, Read(TestModel.Label.Replace("LSB_INTEGER", sampleType, StringComparison.Ordinal)).SampleType);

    [Theory]
    [InlineData("PC_REAL", LdemSampleType.Float32LittleEndian)]
    [InlineData("IEEE_REAL", LdemSampleType.Float32BigEndian)]
    [InlineData("\"PC REAL\"", LdemSampleType.Float32LittleEndian)]
    [InlineData("mac-real", LdemSampleType.Float32BigEndian)]
    public void Read_FloatsInKilometres_BecomeMetres(string sampleType, LdemSampleType expected)
    {
        LdemLabel label = Read(TestModel.FloatLabel(sampleType));

        Assert.Equal(expected, label.SampleType);
        Assert.Equal((1000.0, 1737400.0), (label.ScalingFactor, label.Offset));
    }

    // ^IMAGE in the forms of the PDS Standards Reference 3.8, chapter 14.
    [Theory]
    [InlineData("\"OTHER.IMG\"", "OTHER.IMG", 0)]
    [InlineData("(\"OTHER.IMG\", 3)", "OTHER.IMG", 1440)]
    [InlineData("(\"OTHER.IMG\", 101 <BYTES>)", "OTHER.IMG", 100)]
    [InlineData("8", "LDEM_1.LBL", 5040)]
    [InlineData("5001 <BYTES>", "LDEM_1.LBL", 5000)]
    public void Read_ImagePointer_GivesFileAndOffset(string place, string file, long offset)
    {
        string text = TestModel.Label.Replace("^IMAGE                    = \"LDEM_1.IMG\"", "^IMAGE = " + place, StringComparison.Ordinal);
        LdemLabel label = Read(
            offset == 0 ? text : text.Replace("FILE_RECORDS              = 180", "FILE_RECORDS = 999", StringComparison.Ordinal));

        Assert.Equal((file, offset), (Path.GetFileName(label.ImagePath), label.ImageOffset));
    }

    [Fact]
    public void Read_NasaSplitProduct_IsReadButCoversAPart()
    {
        // LDEM_1024_00N_15N_330_360 has 15359.5 and -153600.5 (thesis, listing of appendix B.3); here the same cut at 1 px/deg.
        LdemLabel label = Read(TestModel.Label
            .Replace("= 180\n", "= 15\n", StringComparison.Ordinal)
            .Replace("= 360\n", "= 30\n", StringComparison.Ordinal)
            .Replace("= 720\n", "= 60\n", StringComparison.Ordinal)
            .Replace("= 90 <deg>", "= 15 <deg>", StringComparison.Ordinal)
            .Replace("= -90 <deg>", "= 0 <deg>", StringComparison.Ordinal)
            .Replace("WESTERNMOST_LONGITUDE        = 0", "WESTERNMOST_LONGITUDE        = 330", StringComparison.Ordinal)
            .Replace("89.5", "14.5", StringComparison.Ordinal)
            .Replace("179.5", "-150.5", StringComparison.Ordinal));

        Assert.False(label.CoversWholeMoon);
        Assert.Equal((15.0, 0.0, 330.0, 360.0), (label.NorthDegrees, label.SouthDegrees, label.WestDegrees, label.EastDegrees));
    }

    [Theory]
    [InlineData(
        "LINES                 = 180", "LINES = 179", "LINES = 179; the map's borders and MAP_RESOLUTION (180 degrees, 1 px/deg) need 180")]
    [InlineData("LINE_SAMPLES          = 360", "LINE_SAMPLES = 361", "LINE_SAMPLES = 361;")]
    [InlineData("LINE_SAMPLES          = 360", "", "IMAGE has no LINE_SAMPLES")]
    [InlineData("LINES                 = 180", "LINES = -180", "LINES = -180; a whole number from 1")]
    [InlineData("LINES                 = 180", "LINES = 180.5", "LINES = 180.5; a whole number from 1")]
    [InlineData("LINES                 = 180", "LINES = \"180\"", "LINES = 180; a finite number is needed")]
    [InlineData("SAMPLE_TYPE           = LSB_INTEGER", "", "IMAGE has no SAMPLE_TYPE")]
    [InlineData(
        "SAMPLE_TYPE           = LSB_INTEGER",
        "SAMPLE_TYPE = LSB_UNSIGNED_INTEGER",
        "SAMPLE_TYPE = LSB_UNSIGNED_INTEGER; with SAMPLE_BITS = 16")]
    [InlineData("SAMPLE_BITS           = 16", "SAMPLE_BITS = 8", "SAMPLE_TYPE = LSB_INTEGER; with SAMPLE_BITS = 8")]
    [InlineData("SAMPLE_BITS           = 16", "SAMPLE_BITS = 16 BANDS = 3", "BANDS = 3; the rest of the label needs 1")]
    [InlineData("SAMPLE_BITS           = 16", "SAMPLE_BITS = 16 LINE_PREFIX_BYTES = 4", "LINE_PREFIX_BYTES = 4;")]
    [InlineData("SAMPLE_BITS           = 16", "SAMPLE_BITS = 16 ENCODING_TYPE = JP2", "ENCODING_TYPE = JP2; an image without compression")]
    [InlineData("SCALING_FACTOR        = 0.5", "", "IMAGE has no SCALING_FACTOR")]
    [InlineData("SCALING_FACTOR        = 0.5", "SCALING_FACTOR = 0", "SCALING_FACTOR = 0; a number above 0")]
    [InlineData("SCALING_FACTOR        = 0.5", "SCALING_FACTOR = NaN", "SCALING_FACTOR = NaN; a finite number")]
    [InlineData("SCALING_FACTOR        = 0.5", "SCALING_FACTOR = 0,5", "',';")]
    [InlineData("OFFSET                = 1737400.", "", "IMAGE has no OFFSET")]
    [InlineData("OFFSET                = 1737400.", "OFFSET = 100.", "OFFSET = 100.; with MINIMUM")]
    [InlineData("OFFSET                = 1737400.", "OFFSET = 1e400", "OFFSET = 1e400; a finite number")]
    [InlineData(
        "OFFSET                = 1737400.", "OFFSET = 1738000.", "A_AXIS_RADIUS = 1737.4 <km>; the heights are over a sphere of 1738000 m")]
    [InlineData("UNIT                  = METER", "UNIT = FOOT", "UNIT = FOOT; METER or KILOMETER")]
    [InlineData("UNIT                  = METER", "", "IMAGE has no UNIT")]
    [InlineData("MAXIMUM               = 21008", "MAXIMUM = 40000", "MINIMUM = -17758; with MAXIMUM = 40000 no 16-bit sample")]
    [InlineData("MAXIMUM               = 21008", "MAXIMUM = -20000", "MINIMUM = -17758; with MAXIMUM = -20000")]
    [InlineData(
        "FILE_RECORDS              = 180",
        "FILE_RECORDS = 181",
        "FILE_RECORDS = 181; with RECORD_BYTES = 720 these are 130320 bytes, but the image needs 129600")]
    [InlineData("RECORD_BYTES              = 720", "RECORD_BYTES = 719", "FILE_RECORDS = 180; with RECORD_BYTES = 719")]
    [InlineData("^IMAGE                    = \"LDEM_1.IMG\"", "", "the label has no ^IMAGE")]
    [InlineData("^IMAGE                    = \"LDEM_1.IMG\"", "^IMAGE = \"../LDEM_1.IMG\"", "^IMAGE = ../LDEM_1.IMG; the plain name")]
    [InlineData("^IMAGE                    = \"LDEM_1.IMG\"", "^IMAGE = \"LDEM\0_1.IMG\"", "the plain name")]
    [InlineData("^IMAGE                    = \"LDEM_1.IMG\"", "^IMAGE = (\"LDEM_1.IMG\", 0)", "^IMAGE = 0; a record or byte number from 1")]
    [InlineData("^IMAGE                    = \"LDEM_1.IMG\"", "^IMAGE = (1, 2, 3)", "^IMAGE = (1, 2, 3); a file name")]
    [InlineData(
        "SIMPLE CYLINDRICAL", "SINUSOIDAL",
        "MAP_PROJECTION_TYPE = SINUSOIDAL; SIMPLE CYLINDRICAL or POLAR STEREOGRAPHIC is needed")]
    [InlineData("SIMPLE CYLINDRICAL", "POLAR STEREOGRAPHIC", "CENTER_LATITUDE = 0 <deg>; a pole, -90 or 90, is needed")]
    [InlineData("MAP_RESOLUTION               = 1 <pix/deg>", "", "IMAGE_MAP_PROJECTION has no MAP_RESOLUTION")]
    [InlineData("MAP_RESOLUTION               = 1 <pix/deg>", "MAP_RESOLUTION = 2 <pix/deg>", "LINES = 180;", "2 px/deg) need 360")]
    [InlineData(
        "MAP_RESOLUTION               = 1 <pix/deg>", "MAP_RESOLUTION = 1 <m/pix>", "MAP_RESOLUTION = 1 <m/pix>; the unit <pix/deg>")]
    [InlineData(
        "MAP_RESOLUTION               = 1 <pix/deg>", "MAP_RESOLUTION = 1.5 <pix/deg>", "MAP_RESOLUTION = 1.5 <pix/deg>; a whole number")]
    [InlineData(
        "MAP_RESOLUTION               = 1 <pix/deg>", "MAP_RESOLUTION = 0 <pix/deg>", "MAP_RESOLUTION = 0 <pix/deg>; a whole number")]
    [InlineData("89.5 <pix>", "90 <pix>", "LINE_PROJECTION_OFFSET = 90 <pix>; the rest of the label needs 89.5")]
    [InlineData("179.5 <pix>", "180 <pix>", "SAMPLE_PROJECTION_OFFSET = 180 <pix>;")]
    [InlineData("\"EAST\"", "\"WEST\"", "POSITIVE_LONGITUDE_DIRECTION = WEST; EAST is needed")]
    [InlineData("MAP_PROJECTION_ROTATION      = 0.0", "MAP_PROJECTION_ROTATION = 90", "MAP_PROJECTION_ROTATION = 90;")]
    [InlineData("LINE_LAST_PIXEL              = 180", "LINE_LAST_PIXEL = 181", "LINE_LAST_PIXEL = 181;")]
    [InlineData(
        "MEAN EARTH/POLAR AXIS OF DE421",
        "PRINCIPAL AXES OF DE421",
        "COORDINATE_SYSTEM_NAME = PRINCIPAL AXES OF DE421; the MEAN EARTH/POLAR AXIS frame")]
    [InlineData("TARGET_NAME               = MOON", "TARGET_NAME = PHOBOS", "TARGET_NAME = PHOBOS; an elevation model of MOON, ME")]
    [InlineData("PRODUCT_ID                = \"LDEM_1\"", "", "the label has no PRODUCT_ID")]
    [InlineData("PRODUCT_ID                = \"LDEM_1\"", "PRODUCT_ID = \"A B\"", "PRODUCT_ID = A B; 1 to 40 letters")]
    public void Read_BadLabel_SaysWhat(string good, string bad, params string[] expected)
    {
        Assert.Contains(good, TestModel.Label, StringComparison.Ordinal);

        BadInputException exception = Assert.Throws<BadInputException>(
            () => Read(TestModel.Label.Replace(good, bad, StringComparison.Ordinal)));

        Assert.StartsWith("/models/LDEM_1.LBL", exception.Message, StringComparison.Ordinal);
        Assert.All(expected, part => Assert.Contains(part, exception.Message, StringComparison.Ordinal));
    }

    [Fact]
    public void Read_WithoutMap_SaysSo()
    {
        string text = TestModel.Label.Replace("IMAGE_MAP_PROJECTION", "SOMETHING", StringComparison.Ordinal);

        Assert.Contains(
            "no OBJECT = IMAGE_MAP_PROJECTION", Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);
    }

    // Spellings of the same facts: blanks and underscores, capitals, plurals, other words for a unit.
    [Theory]
    [InlineData("SIMPLE CYLINDRICAL", "Simple_Cylindrical")]
    [InlineData("\"EAST\"", "east")]
    [InlineData("MEAN EARTH/POLAR AXIS", "MEAN_EARTH/POLAR_AXIS")]
    [InlineData("= MOON", "= \"Moon\"")]
    [InlineData("UNIT                  = METER", "UNIT = \"metres\"")]
    [InlineData("UNIT                  = METER", "Unit = m")]
    [InlineData("<pix/deg>", "<PIXELS / DEGREE>")]
    [InlineData("<deg>", "<DEGREES>")]
    [InlineData("<km>", "<KILOMETRES>")]
    [InlineData("LINE_SAMPLES ", "line_samples ")]
    [InlineData("= IMAGE_MAP_PROJECTION", "= Image_Map_Projection")]
    [InlineData("OFFSET                = 1737400.", "OFFSET = 1737400. <m>")]
    [InlineData("SAMPLE_BITS           = 16", "SAMPLE_BITS = 16 ENCODING_TYPE = \"n/a\"")]
    [InlineData("PDS_VERSION_ID", "CCSD3ZF0000100000001NJPL3IF0PDSX00000001 = SFDU_LABEL\nPDS_VERSION_ID")]
    public void Read_OtherSpelling_SaysTheSame(string was, string becomes)
    {
        string text = TestModel.Label.Replace(was, becomes, StringComparison.Ordinal);
        Assert.NotEqual(TestModel.Label, text);

        Assert.Equal(Read(TestModel.Label), Read(text) with { CoordinateSystem = "MEAN EARTH/POLAR AXIS OF DE421" });
    }

    /// <summary>Without MINIMUM and MAXIMUM a sample may have what the body's ground can: here steps of 0.5 m.</summary>
    [Theory]
    [InlineData("MOON", 1737400, -19000.0, 23000.0)]
    [InlineData("MERCURY", 2439400, -14000.0, 12000.0)]
    [InlineData("MARS", 3396190, -32768.0, 32767.0)] // the sample's own limits
    [InlineData("EUROPA", 1560800, -12000.0, 12000.0)]
    public void Read_WithoutLimits_TakesThoseOfTheBody(string body, int radius, double minimum, double maximum)
    {
        LdemLabel label = Read(TestModel.Label
            .Replace("= MOON", $"= {body}", StringComparison.Ordinal)
            .Replace("1737400.", $"{radius}.", StringComparison.Ordinal)
            .Replace("= 1737.4 ", $"= {radius / 1000}.{radius % 1000:000} ", StringComparison.Ordinal)
            .Replace("MAXIMUM               = 21008", "X = 1", StringComparison.Ordinal)
            .Replace("MINIMUM               = -17758", "Y = 1", StringComparison.Ordinal));

        Assert.Equal((minimum, maximum), (label.Minimum, label.Maximum));
    }

    [Fact]
    public void Read_OffsetWithAnotherUnit_IsRefused() => Assert.Contains(
        "OFFSET = 1737.4 <km>; the unit <m> is needed",
        Assert.Throws<BadInputException>(() => Read(TestModel.Label.Replace("1737400.", "1737.4 <km>", StringComparison.Ordinal))).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Read_CrLfLabel_IsTheSame() =>
        Assert.Equal(Read(TestModel.Label), Read(TestModel.Label.ReplaceLineEndings("\r\n")));

    [Fact]
    public void ReadFile_MissingFile_NamesIt() =>
        Assert.Contains(
            "/nowhere/LDEM_4.LBL: there is no such file",
            Assert.Throws<BadInputException>(() => LdemLabelReader.ReadFile("/nowhere/LDEM_4.LBL")).Message,
            StringComparison.Ordinal);

    private static LdemLabel Read(string text) =>
        LdemLabelReader.Read(new MemoryStream(Encoding.Latin1.GetBytes(text)), "/models/LDEM_1.LBL");
}
