using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class LdemSetTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(45, 90)]
    [InlineData(90, 180)]
    [InlineData(180, 120)]
    [InlineData(15, 30)]
    public void Open_SplitProduct_HasTheSamplesOfTheWhole(int height, int width)
    {
        SplitModel.Write(_folder.Path, height, width);
        using LdemImage image = LdemImage.Open(Find());
        double[] radii = new double[360];

        Assert.Equal(("LDEM_1", 1), (image.ProductId, image.PixelsPerDegree));
        foreach ((int line, int first, int count) in new[] { (0, 0, 360), (44, 351, 360), (45, 80, 33), (89, 100, 7), (90, 359, 2), (
            179, 200, 360) })
        {
            image.ReadRadii(line, first, radii.AsSpan(0, count));
            Assert.Equal(
                Enumerable.Range(first, count).Select(sample => 1737400.0 + (0.5 * TestModel.ValueAt(line, sample % 360))),
                radii.Take(count));
        }
    }

    [Fact]
    public void Join_PartsOfDifferentSizes_IsOneModel()
    {
        SplitModel.WritePart(_folder.Path, 90, 60, 0, 360);
        SplitModel.WritePart(_folder.Path, 60, -90, 0, 200);
        SplitModel.WritePart(_folder.Path, 60, -90, 200, 360);
        using LdemImage image = LdemImage.Open(Find());
        double[] radii = new double[4];

        image.ReadRadii(30, 198, radii);

        Assert.Equal([.. Enumerable.Range(198, 4).Select(sample => 1737400.0 + (0.5 * TestModel.ValueAt(30, sample)))], radii);
    }

    [Fact]
    public void Join_PartsMissing_NamesThem()
    {
        SplitModel.WritePart(_folder.Path, 90, 45, 0, 90);
        SplitModel.WritePart(_folder.Path, 0, -45, 270, 360);

        string message = Assert.Throws<BadInputException>(Find).Message;

        Assert.Contains(
            "of the LDEM_1 product in several files 14 are missing: LDEM_1_45N_90N_090_180, LDEM_1_45N_90N_180_270, ",
            message,
            StringComparison.Ordinal);
        Assert.Contains("LDEM_1_45S_00S_000_090", message, StringComparison.Ordinal);
        Assert.DoesNotContain("LDEM_1_45S_00S_270_360", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Join_VeryManyMissing_NamesTheFirst()
    {
        SplitModel.WritePart(_folder.Path, 15, 0, 0, 30);

        Assert.Contains(
            "143 are missing: LDEM_1_75N_90N_000_030, ", Assert.Throws<BadInputException>(Find).Message, StringComparison.Ordinal);
        Assert.Contains(" and 127 more.", Assert.Throws<BadInputException>(Find).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Join_PartsThatOverlap_NamesBoth()
    {
        SplitModel.Write(_folder.Path, 180, 180);
        SplitModel.WritePart(_folder.Path, 10, 9, 170, 175);

        string message = Assert.Throws<BadInputException>(Find).Message;

        Assert.Contains("LDEM_1_90S_90N_000_180.LBL and ", message, StringComparison.Ordinal);
        Assert.Contains("LDEM_1_09N_10N_170_175.LBL: both cover latitude 9 to 10, longitude 170 to 171", message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("SCALING_FACTOR        = 0.5", "SCALING_FACTOR        = 0.25", "SCALING_FACTOR (in m) is 0.25, but 0.5 in ")]
    [InlineData("1737400.", "1737400.0005", "OFFSET (in m) is 1737400.0005, but 1737400 in ")]
    [InlineData("LSB_INTEGER", "MSB_INTEGER", "SAMPLE_TYPE is Int16BigEndian, but Int16LittleEndian in ")]
    [InlineData("OF DE421", "OF DE440", "COORDINATE_SYSTEM_NAME is MEAN EARTH/POLAR AXIS OF DE440, but ")]
    public void Join_PartsThatDiffer_NamesThemAndWhatDiffers(string was, string becomes, string message)
    {
        string[] names = SplitModel.Write(_folder.Path, 180, 180);
        string label = _folder[names[1] + ".LBL"];
        File.WriteAllText(label, File.ReadAllText(label).Replace(was, becomes, StringComparison.Ordinal));

        BadInputException exception = Assert.Throws<BadInputException>(Find);

        Assert.Contains($"{names[1]}.LBL: {message}", exception.Message, StringComparison.Ordinal);
        Assert.Contains($"{names[0]}.LBL, another part", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_ImagesMissing_NamesAllOfThem()
    {
        string[] names = SplitModel.Write(_folder.Path, 90, 180);
        File.Delete(_folder[names[1] + ".IMG"]);
        File.Delete(_folder[names[3] + ".IMG"]);

        string message = Assert.Throws<BadInputException>(() => LdemImage.Open(Find())).Message;

        Assert.Contains($"2 images are missing: {names[1]}.IMG, {names[3]}.IMG.", message, StringComparison.Ordinal);
    }

    [Fact]
    public void ModelSource_AnyPartChanges_IsAnother()
    {
        string[] names = SplitModel.Write(_folder.Path, 90, 180);
        byte[] before = ModelSource.Of(Find()).Fingerprint();
        Assert.Equal(before, ModelSource.Of(Find()).Fingerprint());

        File.SetLastWriteTimeUtc(_folder[names[0] + ".IMG"], new DateTime(2017, 9, 15, 0, 0, 0, DateTimeKind.Utc));

        Assert.NotEqual(before, ModelSource.Of(Find()).Fingerprint());
    }

    [Fact]
    public void FileBeside_SplitProduct_HasTheNameOfTheModel()
    {
        SplitModel.Write(_folder.Path, 90, 180);

        Assert.Equal(_folder["LDEM_1.pyramid"], Find().FileBeside(".pyramid"));
    }

    private LdemSet Find() => LdemCatalog.Find(1, null, [_folder.Path]);
}
