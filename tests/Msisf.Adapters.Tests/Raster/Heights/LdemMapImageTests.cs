using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class LdemMapImageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>SLDEM2015 has its heights in km, between 60 degrees south and north.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Open_BandInKilometres_HasTheSamplesOfTheWholeMoon(bool isSplit)
    {
        using LdemImage whole = LdemImage.Open(LdemCatalog.Read(Write("whole", MoonRegion.WholeMoon)));
        string label = isSplit ? Write("band", new MoonRegion(-60, 60, 0, 180)) : Write("band", new MoonRegion(-60, 60, 0, 360));
        if (isSplit)
        {
            Write("band", new MoonRegion(-60, 60, 180, 360));
        }

        LdemSet set = LdemCatalog.Find(2, label, []);
        Assert.False(set.IsWholeMoon);
        using LdemMapImage band = LdemMapImage.Open(set);
        Assert.Equal(new GridWindow(60, 300, 0, 720), band.Window);
        double[] expected = new double[720];
        double[] found = new double[720];
        foreach ((int line, int sample) in new[] { (60, 0), (177, 359), (299, 700) })
        {
            whole.ReadRadii(line, sample, expected);
            band.ReadRadii(line, sample, found);
            Assert.Equal(expected, found);
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => band.ReadRadii(59, 0, found));
        Assert.Throws<ArgumentOutOfRangeException>(() => band.ReadRadii(300, 0, found));
        Assert.Contains(
            "covers latitudes -60 to 60 degrees; a model of the whole Moon is needed here",
            Assert.Throws<BadInputException>(() => LdemImage.Open(set)).Message,
            StringComparison.Ordinal);
    }

    /// <summary>Half a band is a split product of which parts are missing.</summary>
    [Fact]
    public void Find_PartOfABand_IsAMapOfItsOwn()
    {
        using LdemMapImage map = LdemMapImage.Open(LdemCatalog.Find(2, Write("half", new MoonRegion(-60, 60, 0, 180)), []));
        Assert.Equal(new GridWindow(60, 300, 0, 360), map.Window);
    }

    private string Write(string name, MoonRegion region) => SyntheticLdemWriter.Write(
        new SyntheticLdemOptions(2, 7, _folder[name])
        {
            Region = region,
            Rest = region == MoonRegion.WholeMoon ? SyntheticRest.Base : SyntheticRest.None,
            Format = SyntheticSampleFormat.Floats,
        },
        progress: null,
        CancellationToken.None);
}
