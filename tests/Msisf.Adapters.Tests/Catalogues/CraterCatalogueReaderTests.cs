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

    /// <summary>Lists as people keep them: what parts the columns, what stands above them, how the columns are called.</summary>
    [Theory]
    [InlineData("ID\tLongitude\tLatitude\tDiameter(km)\tDepth(m)\n1\t182.5\t-48.25\t76.5\t1000\n")]
    [InlineData("id;lon;lat;diam_km\r\n1;182,5;-48,25;76,5\r\n")] // decimal commas, as a German or French spreadsheet saves them
    [InlineData("id;lon;lat;diam_km\n1;182.5;-48.25;76.5\n")]
    [InlineData("ID|Lon_E|Lat|D [km]\n", "Lon_E=")]
    [InlineData("# made by hand\n\n% and commented\nid,lon,lat,diam_km\n# a row below\n1,182.5,-48.25,76.5\n")]
    [InlineData("Lunar crater data base\nAuthors, A. and B., 2021\nColumns are described below.\n"
            + "Crater ID\tLongitude(deg)\tLatitude (deg)\tDiameter [km]\n7\t-177.5\t-48.25\t76.5\n")]
    [InlineData("Center Latitude,Center Longitude,Diameter (m)\n-48.25,182.5,76500\n")]
    [InlineData("LAT_DEG,LON_DEG,D_km,d(m)\n-48.25,182.5,76.5,3000\n")]
    public void Read_ListsAsPeopleKeepThem_GiveTheSameCrater(string text, string? columns = null)
    {
        string rows = columns is null ? text : text + "1|182.5|-48.25|76.5\n";
        using StringReader reader = new(rows);
        ListColumns? given = columns is null ? null : ListColumns.Parse("lon=lon_e");

        IReadOnlyList<Crater> craters = CraterCatalogueReader.ReadAll(reader, "c.csv", 1_737_400.0, given);

        Assert.Equal([(null, -48.25, 182.5, 76_500.0)], craters.Select(Values));
    }

    /// <summary>Columns of any name: the error lists them, and what it advises works.</summary>
    [Fact]
    public void ReadAll_UnknownColumns_AreListedAndCanBeNamed()
    {
        const string text = "Objekt;Breite;Laenge;Durchmesser\nAnna;-48,25;182,5;76,5\n";

        string message = Assert.Throws<BadInputException>(() => ReadAll(text)).Message;

        Assert.StartsWith(
            "c.csv, line 1: no column for the latitude. The columns are 'objekt', 'breite', 'laenge', 'durchmesser'. Say which one it is: "
                + "--columns lat=COLUMN,lon=COLUMN,diam_km=COLUMN.", message, StringComparison.Ordinal);
        string advised = message.Split("--columns ")[1].TrimEnd('.');
        foreach (string name in (string[])["Breite", "Laenge", "Durchmesser"])
        {
            int place = advised.IndexOf("COLUMN", StringComparison.Ordinal);
            advised = advised[..place] + name + advised[(place + "COLUMN".Length)..];
        }

        using StringReader reader = new(text);
        Assert.Equal(
            [("Anna", -48.25, 182.5, 76_500.0)],
            CraterCatalogueReader.ReadAll(reader, "c.csv", 1_737_400.0, ListColumns.Parse(advised + ",name=objekt")).Select(Values));
    }

    /// <summary>By numbers, in a list without names.</summary>
    [Fact]
    public void ReadAll_ColumnsByNumber_AreTaken()
    {
        using StringReader reader = new("# no names\n-48.25 , 182.5 , 76500\n10,20,1000\n");

        Assert.Equal(
            [(null, -48.25, 182.5, 76_500.0), (null, 10.0, 20.0, 1000.0)],
            CraterCatalogueReader.ReadAll(reader, "c.csv", 1_737_400.0, ListColumns.Parse("lat=1,lon=2,diam_m=3")).Select(Values));
    }

    [Theory]
    [InlineData("lat=B,lon=L,diam_km=Weite", "c.csv, line 1: there is no column 'Weite'; there are 'b', 'l', 'd'.")]
    [InlineData("breite=B", "'breite=B' is not KEY=COLUMN with one of the keys id, name, lat, lon, diam_km")]
    [InlineData("lat=B,lat=L", "'lat' is there twice. Leave one out.")]
    [InlineData("lat", "'lat' is not KEY=COLUMN")]
    public void ReadAll_WrongColumns_AreNamed(string columns, string beginning) => Assert.StartsWith(
        beginning,
        Assert.Throws<BadInputException>(() =>
        {
            using StringReader reader = new("B,L,D\n1,2,3\n");
            return CraterCatalogueReader.ReadAll(reader, "c.csv", 1_737_400.0, ListColumns.Parse(columns));
        }).Message,
        StringComparison.Ordinal);

    /// <summary>Names in each encoding, from a file.</summary>
    [Theory]
    [InlineData("utf-8", false)]
    [InlineData("utf-8", true)]
    [InlineData("iso-8859-1", false)]
    [InlineData("utf-16", true)]
    [InlineData("utf-16BE", true)]
    public void ReadAll_Encodings_KeepNames(string encoding, bool hasMark)
    {
        using TemporaryFolder folder = new();
        System.Text.Encoding of = System.Text.Encoding.GetEncoding(encoding);
        byte[] text = of.GetBytes("name,lat,lon,diam_km\nB\u00e9la \u00d6,10,20,60\n");
        File.WriteAllBytes(folder["c.csv"], hasMark ? [.. of.GetPreamble(), .. text] : text);

        Assert.Equal("B\u00e9la \u00d6", Assert.Single(CraterCatalogueReader.ReadAll(folder["c.csv"], 1_737_400.0)).Name);
    }

    [Theory]
    [InlineData("PK\u0003\u0004", "Save the sheet as CSV")]
    [InlineData("{\"type\": \"FeatureCollection\"}", "ogr2ogr -f CSV")]
    [InlineData("SQLite format 3\0", "ogr2ogr -f CSV")]
    public void ReadAll_KnownFormat_IsNamedWithWhatToDo(string content, string advice)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["c.csv"], content);

        string message = Assert.Throws<BadInputException>(() => CraterCatalogueReader.ReadAll(folder["c.csv"], 1_737_400.0)).Message;
        Assert.Contains("which is not read here", message, StringComparison.Ordinal);
        Assert.Contains(advice, message, StringComparison.Ordinal);
    }

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
