using Msisf.Adapters.Catalogues;
using Msisf.Core.Errors;
using Msisf.Core.Navigation;
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
        Assert.Equal([(null, -48.25, 182.5, 76_500.0)], Read(text).Select(Values));

    /// <summary>As line 18,165 of Povilaitis et al. (2018) in DeepMoon; an error below it names the right line.</summary>
    [Fact]
    public void Read_FieldOfTwoLines_IsOne()
    {
        const string text = ",Unnamed: 0,Diameter (km),Long,Lat,tag\n0,0,6.5,-23.5,56,\"\r\n?\"\n1,1,7,-19,57,standard\n";

        Assert.Equal([(null, 56.0, 336.5, 6500.0), (null, 57.0, 341.0, 7000.0)], ReadAll(text).Select(Values));
        Assert.Contains(
            ", line 5, ", Assert.Throws<BadInputException>(() => Read(text + "2,2,x,0,0,\n")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_NamesOfTheIau_AreTakenWithCommasAndUmlauts()
    {
        const string text = "Feature Name,Diameter,Center Latitude,Center Longitude\n\"Müller, \"\"old\"\"\",24.2,-7.6,360\nSmall,1,0,0\n";

        Assert.Equal(
            [("Müller, \"old\"", -7.6, 0.0, 24_200.0), ("Small", 0.0, 0.0, 1000.0)], Read(text).Select(Values));
    }

    [Fact]
    public void Read_MoreCratersThanAreKept_KeepsTheLargestFirst()
    {
        string text = "lat,lon,diam_km\n" + string.Concat(
            Enumerable.Range(1, CraterCatalogueReader.MostCraters + 2).Select(
                number => FormattableString.Invariant($"0,0,{number / 100.0}\n")));

        IReadOnlyList<Crater> craters = Read(text);

        Assert.Equal(CraterCatalogueReader.MostCraters, craters.Count);
        Assert.Equal(500_020.0, craters[0].Diameter, 1e-6); // m: km in text times 1000
        Assert.Equal(30.0, craters[^1].Diameter, 1e-6); // m: the same
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

        string message = Assert.Throws<BadInputException>(() => CraterCatalogueReader.ReadLargest(folder["c.csv"])).Message;
        Assert.Contains("no such file", message, StringComparison.Ordinal);
    }

    /// <summary>Robbins (2018): the ellipse with its errors, from east; where it is missing, the circle.</summary>
    [Fact]
    public void ReadAll_RobbinsEllipses_AreTakenWithTheirErrors()
    {
        const string text =
            "CRATER_ID,LAT_CIRC_IMG,LON_CIRC_IMG,LAT_ELLI_IMG,LON_ELLI_IMG,DIAM_CIRC_IMG,DIAM_CIRC_SD_IMG,DIAM_ELLI_MAJOR_IMG,"
            + "DIAM_ELLI_MINOR_IMG,DIAM_ELLI_ANGLE_IMG,LAT_ELLI_SD_IMG,LON_ELLI_SD_IMG,DIAM_ELLI_MAJOR_SD_IMG,DIAM_ELLI_MINOR_SD_IMG,"
            + "DIAM_ELLI_ANGLE_SD_IMG\n"
            + "00-1-000000,-19.8,264.7,-19.9,264.75,940,21,975,905,35.5,0.008,0.009,0.6,0.5,0.4\n"
            + "00-1-000001,10,-20,,,5,0.1,,,,,,,,\n";

        IReadOnlyList<Crater> craters = ReadAll(text);

        Assert.Equal(
            new Crater(1, "00-1-000000", null, -19.9, 264.75, 975e3)
            {
                MinorDiameter = 905e3,
                AngleDegrees = 35.5,
                Errors = new CraterErrors(0.008, 0.009, 600.0, 500.0, 0.4),
            },
            craters[0]);
        Assert.Equal(new Crater(2, "00-1-000001", null, 10.0, 340.0, 5e3), craters[1]);
    }

    [Theory]
    [InlineData("id,lat,lon,diam_km\na,1,2,3\nb,1,2,3\na,1,2,3\n", "c.csv, line 4: the crater 'a' is already in line 2. Remove one.")]
    [InlineData("lat,lon,diam_km\n1,2,0\n", "c.csv, line 2, column 'diam_km': a number from 0 to 3474.8 is needed, above 0.")]
    [InlineData("lat,lon,diam_km\n1,2,5000\n", "c.csv, line 2, column 'diam_km': a number from 0 to 3474.8")]
    [InlineData("lat,lon,diam_km\nNaN,2,3\n", "c.csv, line 2, column 'lat': a number from -90 to 90 is needed. Correct or remove")]
    [InlineData("lat,lon,diam_km\n", "c.csv: no craters below the heading")]
    public void ReadAll_WrongCatalogue_IsRefused(string text, string beginning) =>
        Assert.StartsWith(beginning, Assert.Throws<BadInputException>(() => ReadAll(text)).Message, StringComparison.Ordinal);

    private static (string? Name, double Latitude, double Longitude, double Diameter) Values(Crater crater) =>
        (crater.Name, crater.LatitudeDegrees, crater.LongitudeDegrees, crater.Diameter);

    private static IReadOnlyList<Crater> ReadAll(string text)
    {
        using StringReader reader = new(text);
        return CraterCatalogueReader.ReadAll(reader, "c.csv", 1_737_400.0);
    }

    private static IReadOnlyList<Crater> Read(string text)
    {
        using StringReader reader = new(text);
        return CraterCatalogueReader.ReadLargest(reader, "c.csv");
    }
}
