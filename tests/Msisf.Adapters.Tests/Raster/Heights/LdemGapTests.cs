using System.Buffers.Binary;
using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>Fill values in LOLA's own format are no pits: what can't be a height has no data, as in rasters that GDAL reads.</summary>
public sealed class LdemGapTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>What the label says of the samples, and the samples at line 11, 21 to 23 and line 180, 360.</summary>
    [Theory]
    [InlineData("LSB_INTEGER", "MINIMUM = -32768", -32768.0, true)]
    [InlineData("MSB_INTEGER", "MINIMUM = -32768", -32768.0, true)]
    [InlineData("LSB_INTEGER", "MINIMUM = -19001", -19001.0, true)]
    [InlineData("LSB_INTEGER", "MAXIMUM = 32767 MINIMUM = -17758", 32767.0, true)]
    [InlineData("LSB_INTEGER", "", -32768.0, true)]
    [InlineData("LSB_INTEGER", "MISSING_CONSTANT = -32768", -32768.0, false)]
    [InlineData("LSB_INTEGER", "MINIMUM = -32768 MISSING_CONSTANT = 32767", 32767.0, false)]
    [InlineData("LSB_INTEGER", "MINIMUM = -32768 MISSING_CONSTANT = 32767", -32768.0, true)]
    [InlineData("PC_REAL", "MINIMUM = -32768", -32768.0, true)]
    [InlineData("PC_REAL", "MINIMUM = -3.4028227E+38", -3.4028227e38, true)]
    [InlineData("PC_REAL", "MAXIMUM = 1.0E+38", double.NaN, true)]
    [InlineData("IEEE_REAL", "INVALID_CONSTANT = -9999.0", -9999.0, false)]
    [InlineData("LSB_INTEGER", "MISSING_CONSTANT = 16#8000#", -32768.0, false)]
    [InlineData("PC_REAL", "MISSING_CONSTANT = 16#FF7FFFFB#", -3.4028226550889045e38, false)]
    [InlineData("LSB_INTEGER", "MINIMUM = -32768 MISSING_CONSTANT = \"N/A\"", -32768.0, true)]
    public void Open_FillValues_AreNoData(string sampleType, string says, double fill, bool isWorthANote)
    {
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(Write(sampleType, says, fill)));
        using LdemMapImage map = LdemMapImage.Of(image);

        Assert.True(map.MayHaveGaps);
        Assert.Equal(isWorthANote, map.NoteOfGaps() is not null);
        if (isWorthANote)
        {
            Assert.Contains(
                "LDEM_1.IMG: 4 pixels cannot be heights, though the file does not say that they have no data; the first is line 11, "
                    + "sample 21 (", map.NoteOfGaps(), StringComparison.Ordinal);
        }

        Assert.Equal([10, 179], Enumerable.Range(0, TestModel.Lines).Where(line => map.MayHaveGapsIn(line, 1, 0, TestModel.Samples)));
        bool[] gaps = new bool[TestModel.Samples];
        map.ReadGaps(10, 359, gaps); // across the prime meridian
        Assert.Equal([21, 22, 23], Enumerable.Range(0, gaps.Length).Where(i => gaps[i]));
        double[] radius = new double[1];
        map.ReadRadii(10, 23, radius);
        Assert.Equal(1_737_400.0 + (0.5 * TestModel.ValueAt(10, 23)), radius[0], 1e-3);
        Assert.Contains(
            "LDEM_1.IMG, line 11, sample 23: no data there.",
            Assert.Throws<BadInputException>(() => map.ReadRadii(10, 22, radius)).Message, StringComparison.Ordinal);
        map.ReadGaps(179, 359, gaps.AsSpan(0, 1));
        Assert.True(gaps[0]);
    }

    /// <summary>A label may allow what no sample has; the model is one of the whole Moon then.</summary>
    [Fact]
    public void Open_WideLimitsWithoutFillValues_HasNoGaps()
    {
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(Write("LSB_INTEGER", "MINIMUM = -32768", fill: 7.0)));

        Assert.Equal((false, null), (image.HasGaps, image.NoteOfGaps()));
        Assert.Equal((1_737_400.0 - 9500.0, 1_737_400.0 + 10_504.0), image.RadiusLimits);
    }

    /// <summary>What contradicts the label is damage, until the label no longer says so.</summary>
    [Fact]
    public void ReadRadii_FillValueOutsideTheLimits_IsNoDataAsAdvised()
    {
        string path = Write("LSB_INTEGER", "MINIMUM = -17758", -32768.0);
        using (LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(path)))
        {
            Assert.False(image.HasGaps);
            Assert.EndsWith(
                "If such values mean no data, delete MINIMUM and MAXIMUM from the label.",
                Assert.Throws<BadInputException>(() => image.ReadRadii(10, 20, new double[1])).Message, StringComparison.Ordinal);
        }

        File.WriteAllText(path, Regex.Replace(File.ReadAllText(path), "(MINIMUM|MAXIMUM) *= [-0-9]+\n", "\n"));
        using LdemImage advised = LdemImage.Open(LdemLabelReader.ReadFile(path));
        Assert.True(advised.HasGaps);
    }

    /// <summary>A declared value between the heights needs a reader that compares each sample with it.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Read_MissingConstantThatIsAHeight_IsReadAsAdvised()
    {
        string path = Write("LSB_INTEGER", "MISSING_CONSTANT = 0", fill: 0.0);
        File.WriteAllText(path, File.ReadAllText(path).Replace(
            "MAP_PROJECTION_ROTATION", "MAP_SCALE = 30.3233504236 <km/pix>\n MAP_PROJECTION_ROTATION", StringComparison.Ordinal));
        Match advice = Regex.Match(
            Assert.Throws<BadInputException>(() => LdemLabelReader.ReadFile(path)).Message,
            "MISSING_CONSTANT = 0 is a height that can be. Convert the file: (gdal_translate) ((-[a-z_]+ [0-9.]+ )+).* NEW.tif");
        string[] words = advice.Groups[2].Value.TrimEnd().Split(' ');
        ChildRun.Of(advice.Groups[1].Value, ["-q", .. words, path, _folder["new.tif"]], _folder.Path).Succeeded();

        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);
        bool[] gaps = new bool[3];
        grid.ReadGaps(10, 20, gaps);
        Assert.Equal([true, true, true], gaps);
        double[] radius = new double[1];
        grid.ReadRadii(10, 23, radius);
        Assert.Equal(1_737_400.0 + (0.5 * TestModel.ValueAt(10, 23)), radius[0], 1e-3);
    }

    private string Write(string sampleType, string says, double fill)
    {
        bool hasFloats = sampleType.EndsWith("REAL", StringComparison.Ordinal);
        bool isBig = sampleType is "MSB_INTEGER" or "IEEE_REAL";
        string label = hasFloats
            ? TestModel.FloatLabel(sampleType)
            : TestModel.Label.Replace("LSB_INTEGER", sampleType, StringComparison.Ordinal);
        string stated = says.Contains("MAXIMUM", StringComparison.Ordinal) ? "M[AI][XN]IMUM" : "MINIMUM";
        label = Regex.Replace(label, says.Length == 0 ? "M[AI][XN]IMUM  +=.*\n" : $"{stated}  +=.*\n", string.Empty);
        label = label.Replace("SAMPLE_BITS", $"{says}\n SAMPLE_BITS", StringComparison.Ordinal);
        byte[] image = hasFloats ? TestModel.FloatImage(isBig) : TestModel.IntegerImage(isBig);
        foreach ((int line, int sample) in ((int, int)[])[(10, 20), (10, 21), (10, 22), (179, 359)])
        {
            Span<byte> at = image.AsSpan(((line * TestModel.Samples) + sample) * (hasFloats ? sizeof(float) : sizeof(short)));
            Action<Span<byte>> write = (hasFloats, isBig) switch
            {
                (false, false) => bytes => BinaryPrimitives.WriteInt16LittleEndian(bytes, (short)fill),
                (false, true) => bytes => BinaryPrimitives.WriteInt16BigEndian(bytes, (short)fill),
                (true, false) => bytes => BinaryPrimitives.WriteSingleLittleEndian(bytes, (float)fill),
                (true, true) => bytes => BinaryPrimitives.WriteSingleBigEndian(bytes, (float)fill),
            };
            write(at);
        }

        return TestModel.Write(_folder.Path, label, image);
    }
}
