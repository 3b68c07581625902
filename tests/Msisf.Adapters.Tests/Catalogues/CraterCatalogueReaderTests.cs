using Msisf.Adapters.Catalogues;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Catalogues;

/// <summary>The heads are those of the published files.</summary>
public class CraterCatalogueReaderTests
{
    [Theory]
    [InlineData("Lon,Lat,Diam_km\n-177.5,-48.25,76.5\n")] // Head et al. (2010), as DeepMoon has it
    [InlineData(",Unnamed: 0,Diameter (km),Long,Lat,tag\n0,0,76.5,182.5,-48.25,standard\n")] // Povilaitis et al. (2018), the same
    [InlineData("CRATER_ID,LAT_ELLI_IMG,LON_ELLI_IMG,DIAM_ELLI_MAJOR_IMG\r\n00-1-000000,-48.25,182.5,76.5\r\n\r\n")] // Robbins (2018)
    public void Read_PublishedForms_GiveTheSameCrater(string text) =>
        Assert.Equal([new CatalogueCrater(null, -48.25, 182.5, 76_500.0)], Read(text));

    [Fact]
    public void Read_NamesOfTheIau_AreTakenWithCommasAndUmlauts()
    {
        const string text = "Feature Name,Diameter,Center Latitude,Center Longitude\n\"Müller, \"\"old\"\"\",24.2,-7.6,360\nSmall,1,0,0\n";

        Assert.Equal([new CatalogueCrater("Müller, \"old\"", -7.6, 0.0, 24_200.0), new CatalogueCrater("Small", 0.0, 0.0, 1000.0)], Read(text));
    }

    [Fact]
    public void Read_MoreCratersThanAreKept_KeepsTheLargestFirst()
    {
        string text = "lat,lon,diam_km\n" + string.Concat(
            Enumerable.Range(1, CraterCatalogueReader.MostCraters + 2).Select(number => FormattableString.Invariant($"0,0,{number / 100.0}\n")));

        IReadOnlyList<CatalogueCrater> craters = Read(text);

        Assert.Equal(CraterCatalogueReader.MostCraters, craters.Count);
        Assert.Equal(500_020.0, craters[0].Diameter, 1e-6);
        Assert.Equal(30.0, craters[^1].Diameter, 1e-6);
    }

    [Theory]
    [InlineData("Lon,Lat\n1,2\n", "c.csv, line 1: no column for the diameter in km")]
    [InlineData("Lon,Lat,Diam_km\n1,2,3\n1,91,3\n", "c.csv, line 3, column 'lat': a number from -90 to 90 is needed")]
    [InlineData("Lon,Lat,Diam_km\n1,2\n", "c.csv, line 2, column 'diam_km': a number")]
    [InlineData("", "c.csv, line 1: no column for the latitude")]
    public void Read_WrongFile_IsNamedByLineAndColumn(string text, string beginning) =>
        Assert.StartsWith(beginning, Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);

    [Fact]
    public void Read_NoFile_IsNamed()
    {
        using TemporaryFolder folder = new();

        Assert.Contains("no such file", Assert.Throws<BadInputException>(() => CraterCatalogueReader.Read(folder["c.csv"])).Message, StringComparison.Ordinal);
    }

    private static IReadOnlyList<CatalogueCrater> Read(string text)
    {
        using StringReader reader = new(text);
        return CraterCatalogueReader.Read(reader, "c.csv");
    }
}
