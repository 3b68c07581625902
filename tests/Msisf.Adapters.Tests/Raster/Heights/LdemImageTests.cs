using System.Text;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class LdemImageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void ReadRadii_RealLdem4_HasTheKnownExtremesAtTheirPlaces()
    {
        // LDEM_4 V3.0: 10504.0 m at 5.375 N 201.375 E, -8878.5 m at 70.375 S 187.625 E.
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        double[] radius = new double[1];

        image.ReadRadii(line: 338, firstSample: 805, radius);
        Assert.Equal(1737400.0 + 10504.0, radius[0]);
        image.ReadRadii(line: 641, firstSample: 750, radius);
        Assert.Equal(1737400.0 - 8878.5, radius[0]);
        Assert.Equal((1737400.0 - 8878.5, 1737400.0 + 10504.0), image.RadiusBounds(0, 720, 0, 1440));
    }

    [RequiresFact(Part.Ldem4)]
    public void RadiusLimits_RealLdem4_AreTheLabels()
    {
        // MINIMUM = -17758, MAXIMUM = 21008, SCALING_FACTOR = 0.5, OFFSET = 1737400.
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));

        Assert.Equal((1737400.0 - 8879.0, 1737400.0 + 10504.0), image.RadiusLimits);
    }

    [Theory]
    [InlineData(LdemSampleType.Int16BigEndian)]
    [InlineData(LdemSampleType.Float32LittleEndian)]
    public void RadiusLimits_EachSampleType_HoldAllRadii(LdemSampleType type)
    {
        using LdemImage image = Open(type);
        (double minimum, double maximum) = image.RadiusBounds(0, TestModel.Lines, 0, TestModel.Samples);

        Assert.InRange(minimum, image.RadiusLimits.Min, maximum);
        Assert.InRange(maximum, minimum, image.RadiusLimits.Max);
    }

    [Theory]
    [InlineData(LdemSampleType.Int16LittleEndian, 0.0)]
    [InlineData(LdemSampleType.Int16BigEndian, 0.0)]
    [InlineData(LdemSampleType.Float32LittleEndian, 0.001)] // m: half a float's step at 10 km
    [InlineData(LdemSampleType.Float32BigEndian, 0.001)]
    public void ReadRadii_EachSampleType_GivesOffsetPlusScaledValue(LdemSampleType type, double tolerance)
    {
        using LdemImage image = Open(type);
        double[] radii = new double[TestModel.Samples];
        for (int line = 0; line < TestModel.Lines; line += 7)
        {
            image.ReadRadii(line, firstSample: 351, radii);
            for (int i = 0; i < radii.Length; i++)
            {
                double expected = 1737400.0 + (0.5 * TestModel.ValueAt(line, (351 + i) % TestModel.Samples));
                Assert.InRange(radii[i], expected - tolerance, expected + tolerance);
            }
        }
    }

    [Theory]
    [InlineData(LdemSampleType.Int16LittleEndian)]
    [InlineData(LdemSampleType.Int16BigEndian)]
    [InlineData(LdemSampleType.Float32LittleEndian)]
    [InlineData(LdemSampleType.Float32BigEndian)]
    public void ReadRadii_AnyLength_HasTheBitsOfSingleReads(LdemSampleType type)
    {
        using LdemImage image = Open(type);
        double[] single = new double[70];
        double[] run = new double[70];
        for (int i = 0; i < single.Length; i++)
        {
            image.ReadRadii(91, 100 + i, single.AsSpan(i, 1));
        }

        for (int length = 1; length <= run.Length; length++)
        {
            Array.Fill(run, double.NaN);
            image.ReadRadii(91, 100, run.AsSpan(0, length));
            Assert.Equal(single.Take(length), run.Take(length));
        }
    }

    [Fact]
    public void Prefetch_AnyBlock_LeavesTheSamplesAsTheyAre()
    {
        using LdemImage image = Open(LdemSampleType.Int16LittleEndian);
        double[] radii = new double[TestModel.Samples];
        double[] before = new double[TestModel.Samples];
        image.ReadRadii(179, 350, before);

        image.Prefetch(0, 180, 0, 360);
        image.Prefetch(178, 2, 350, 29); // across the prime meridian, and to the end of the file

        image.ReadRadii(179, 350, radii);
        Assert.Equal(before, radii);
        Assert.Throws<ArgumentOutOfRangeException>(() => image.Prefetch(178, 3, 0, 1));
    }

    [Theory]
    [InlineData(-2, 129598)]
    [InlineData(2, 129602)]
    public void Open_FileOfAnotherLength_TellsExpectedAndFoundBytes(int change, int found)
    {
        byte[] bytes = TestModel.IntegerImage(bigEndian: false);
        Array.Resize(ref bytes, bytes.Length + change);
        string label = TestModel.Write(_folder.Path, TestModel.Label, bytes);

        BadInputException exception = Assert.Throws<BadInputException>(() => LdemImage.Open(LdemLabelReader.ReadFile(label)));

        Assert.Contains($"LDEM_1.IMG: {found} bytes, 129600 expected (180 lines of 720 bytes", exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0, false)]
    [InlineData(17, true)]
    [InlineData(359, false)]
    public void ReadRadii_DamagedSample_NamesLineAndSample(int sample, bool isBigEndian)
    {
        byte[] bytes = TestModel.IntegerImage(isBigEndian);
        bytes.AsSpan(((41 * 360) + sample) * 2, 2).Fill(0x7f); // 32639
        using LdemImage image = Open(isBigEndian ? LdemSampleType.Int16BigEndian : LdemSampleType.Int16LittleEndian, bytes);
        double[] radii = new double[360];
        string expected =
            $"LDEM_1.IMG, line 42, sample {sample + 1}: the value 32639 is outside the label's MINIMUM and MAXIMUM (-17758 to 21008)";

        image.ReadRadii(40, 0, radii);
        Assert.Contains(expected, Assert.Throws<BadInputException>(() => image.ReadRadii(41, 0, radii)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void ReadRadii_NotANumber_NamesLineAndSample()
    {
        byte[] bytes = TestModel.FloatImage(bigEndian: false);
        bytes.AsSpan(360 * 4, 4).Fill(0xff);
        using LdemImage image = Open(LdemSampleType.Float32LittleEndian, bytes);

        Assert.Contains(
            "line 2, sample 1: the value NaN",
            Assert.Throws<BadInputException>(() => image.ReadRadii(1, 0, new double[3])).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Open_NameInSmallLetters_IsFound()
    {
        string label = TestModel.Write(_folder.Path, TestModel.Label, TestModel.IntegerImage(bigEndian: false), "ldem_1.img");
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(label));

        Assert.Equal((1, "LDEM_1"), (image.PixelsPerDegree, image.ProductId));
    }

    [Fact]
    public void Open_AttachedLabel_ReadsBehindIt()
    {
        string text = TestModel.Label
            .Replace("^IMAGE                    = \"LDEM_1.IMG\"", "^IMAGE = 8", StringComparison.Ordinal)
            .Replace("FILE_RECORDS              = 180", "FILE_RECORDS = 187", StringComparison.Ordinal);
        byte[] bytes = new byte[187 * 720];
        Encoding.ASCII.GetBytes(text, bytes);
        TestModel.IntegerImage(bigEndian: false).CopyTo(bytes, 7 * 720);
        File.WriteAllBytes(_folder["LDEM_1.IMG"], bytes);
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(_folder["LDEM_1.IMG"]));
        double[] radii = new double[1];

        image.ReadRadii(179, 359, radii);

        Assert.Equal(1737400.0 + (0.5 * TestModel.ValueAt(179, 359)), radii[0]);
    }

    [Fact]
    public void Open_MissingImage_SaysWhereItShouldBe()
    {
        File.WriteAllText(_folder["LDEM_1.LBL"], TestModel.Label);

        Assert.Contains(
            "LDEM_1.IMG: missing;",
            Assert.Throws<BadInputException>(() => LdemImage.Open(LdemLabelReader.ReadFile(_folder["LDEM_1.LBL"]))).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Open_PartOfTheMoon_SaysWhatIsMissing()
    {
        File.WriteAllText(_folder["LDEM_1.LBL"], TestModel.Label);
        LdemLabel part = LdemLabelReader.ReadFile(_folder["LDEM_1.LBL"]) with { SouthDegrees = 0.0 };

        Assert.Contains(
            "1 are missing: latitudes -90 to 0, longitudes 0 to 360. Put their .LBL and .IMG files beside LDEM_1.LBL",
            Assert.Throws<BadInputException>(() => LdemImage.Open(part)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void ReadRadii_AfterDispose_Throws()
    {
        LdemImage image = Open(LdemSampleType.Int16LittleEndian);
        image.Dispose();
        image.Dispose();

        Assert.Throws<ObjectDisposedException>(() => image.ReadRadii(0, 0, new double[1]));
    }

    [Theory]
    [InlineData(-1, 0, 1)]
    [InlineData(180, 0, 1)]
    [InlineData(0, -1, 1)]
    [InlineData(0, 360, 1)]
    [InlineData(0, 0, 361)]
    public void ReadRadii_OutsideTheGrid_Throws(int line, int firstSample, int count)
    {
        using LdemImage image = Open(LdemSampleType.Int16LittleEndian);

        Assert.Throws<ArgumentOutOfRangeException>(() => image.ReadRadii(line, firstSample, new double[count]));
    }

    private LdemImage Open(LdemSampleType type, byte[]? bytes = null)
    {
        (string label, byte[] image) = type switch
        {
            LdemSampleType.Int16LittleEndian => (TestModel.Label, TestModel.IntegerImage(bigEndian: false)),
            LdemSampleType.Int16BigEndian =>
                (TestModel.Label.Replace("LSB_", "MSB_", StringComparison.Ordinal), TestModel.IntegerImage(bigEndian: true)),
            LdemSampleType.Float32LittleEndian => (TestModel.FloatLabel("PC_REAL"), TestModel.FloatImage(bigEndian: false)),
            _ => (TestModel.FloatLabel("IEEE_REAL"), TestModel.FloatImage(bigEndian: true)),
        };
        return LdemImage.Open(LdemLabelReader.ReadFile(TestModel.Write(_folder.Path, label, bytes ?? image)));
    }
}
