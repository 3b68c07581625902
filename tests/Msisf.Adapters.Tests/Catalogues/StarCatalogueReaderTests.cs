using Msisf.Adapters.Catalogues;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Sky;
using Xunit;

namespace Msisf.Adapters.Tests.Catalogues;

public sealed class StarCatalogueReaderTests
{
    /// <summary>mas in a radian.</summary>
    private const double Mas = 648_000_000.0 / Math.PI;

    [Fact]
    public void Read_BuiltIn_HasSirius()
    {
        StarCatalogueFile file = StarCatalogueReader.Read(StarCatalogueReader.BuiltIn, null);

        Assert.Equal(5112, file.Catalogue.Stars.Count);
        Assert.Equal("bright.csv", file.File!.Name);
        Star sirius = file.Catalogue.Stars.Single(star => star.Identity == "HIP 32349");
        AssertPlace(101.28854105, -16.71314306, sirius);
        Assert.Equal(double.Hypot(546.01, 1223.07), sirius.ProperMotion.Length * Mas, 1e-9);
        Assert.Equal((-8.75, -1.44), (sirius.EpochYears, sirius.Magnitude));
        Assert.Equal(2, file.Catalogue.Stars.Count(star => star.Colour is null));
    }

    [Fact]
    public void Read_Limit_LeavesOutFainterStars() =>
        Assert.All(StarCatalogueReader.Read(StarCatalogueReader.BuiltIn, 2.0).Catalogue.Stars, star => Assert.True(star.Magnitude <= 2.0));

    [Fact]
    public void Read_Hipparcos_TakesItsFields()
    {
        string[] fields = new string[78];
        Array.Fill(fields, " ");
        (fields[0], fields[1], fields[3], fields[4], fields[5]) = ("H", "  32349", "06 45 09.25", "-16 42 47.3", "-1.44");
        (fields[8], fields[9], fields[11], fields[12], fields[13], fields[37]) =
            ("101.28854105", "-16.71314306", " 379.21", "-546.01", "-1223.08", " 0.009");
        string sirius = string.Join('|', fields);
        (fields[1], fields[8], fields[9]) = ("55203", " ", " "); // of those without an astrometric solution
        string other = string.Join('|', fields);
        (fields[1], fields[5]) = ("1", " ");

        StarCatalogueFile file = Read($"{sirius}\n{other}\n{string.Join('|', fields)}\n");

        Assert.Equal(["HIP 32349", "HIP 55203"], file.Catalogue.Stars.Select(star => star.Identity));
        Assert.Equal(1, file.WithoutMagnitude);
        Star star = file.Catalogue.Stars[0];
        AssertPlace(101.28854105, -16.71314306, star);
        AssertPlace(15.0 * (6.0 + (45.0 / 60.0) + (9.25 / 3600.0)), -(16.0 + (42.0 / 60.0) + (47.3 / 3600.0)), file.Catalogue.Stars[1]);
        Assert.Equal(-1223.08, star.ProperMotion.Z / Math.Cos(double.DegreesToRadians(-16.71314306)) * Mas, 1e-9);
        Assert.Equal(379.21, star.Parallax * Mas, 1e-9);
        Assert.Equal((-8.75, -1.44, 0.009), (star.EpochYears, star.Magnitude, star.Colour));
    }

    [Fact]
    public void Read_Tycho2_MakesJohnsonMagnitudes()
    {
        string[] fields = new string[32];
        Array.Fill(fields, " ");
        (fields[0], fields[2], fields[3], fields[4], fields[5]) = ("0001 00008 1", "  2.31750494", "  2.23184345", "  -16.3", "   -9.0");
        (fields[17], fields[19], fields[24], fields[25], fields[26], fields[27]) =
            ("12.146", "12.046", "2.31754222", "2.23186444", "1.67", "1.54");
        string both = string.Join('|', fields);
        (fields[0], fields[1], fields[2], fields[3], fields[17]) = ("0001 00013 1", "X", " ", " ", " ");
        string observed = string.Join('|', fields);

        IReadOnlyList<Star> stars = Read($"{both}\n{observed}\n").Catalogue.Stars;

        Assert.Equal(["TYC 1-8-1", "TYC 1-13-1"], stars.Select(star => star.Identity));
        AssertPlace(2.31750494, 2.23184345, stars[0]);
        Assert.Equal((0.0, 12.046 - 0.009), (stars[0].EpochYears, stars[0].Magnitude));
        Assert.Equal(0.085, stars[0].Colour!.Value, 1e-12);
        AssertPlace(2.31754222, 2.23186444, stars[1]);
        Assert.Equal(-8.33, stars[1].EpochYears, 1e-12);
        Assert.Equal(default, stars[1].ProperMotion);
        Assert.Null(stars[1].Colour);
        Assert.Equal(12.046 - (0.09 * 0.653 / 0.85), stars[1].Magnitude, 1e-12);
    }

    [Fact]
    public void Read_Csv_NeedsPlaceAndMagnitudeOnly()
    {
        IReadOnlyList<Star> stars = Read("# mine\nname;RA [deg];Dec [deg];Vmag;epoch\nA;10,5;-20;3,5;\nB;20;30;4;2010.5\n").Catalogue.Stars;

        Assert.Equal([("A", 3.5, 0.0), ("B", 4.0, 10.5)], stars.Select(star => (star.Identity, star.Magnitude, star.EpochYears)));
        AssertPlace(10.5, -20.0, stars[0]);
    }

    [Theory]
    [InlineData("", "it is empty")]
    [InlineData("ra_h,dec_deg,v_mag\n1,2,3\n", "these are not columns of stars: ra_h, dec_deg, v_mag")]
    [InlineData("RA (h),dec,v_mag\n1,2,3\n", "these are not columns of stars")]
    [InlineData("ra_deg,dec_deg,v_mag\n1,2,99\n", "line 2, column 'v_mag': a number from -2 to 30 is needed")]
    [InlineData("ra_deg,dec_deg,v_mag\n1,95,9\n", "line 2, column 'dec_deg': a number from -90 to 90")]
    [InlineData("ra_deg,dec_deg,v_mag,pmra\n1,5,9,2e6\n", "column 'pmra': a number from -15000 to 15000")]
    [InlineData("hip,ra_deg,dec_deg,v_mag\n7,5,9,2\n7,6,9,2\n", "the star 'HIP 7' is there twice")]
    [InlineData("ra_deg,dec_deg,v_mag\n", "no stars in it")]
    public void Read_Wrong_NamesFileAndLine(string text, string message) =>
        Assert.Contains(message, Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);

    [Fact]
    public void Read_HoursInPlaceOfDegrees_IsFound()
    {
        string rows = string.Concat(Enumerable.Range(0, 100).Select(index => $"{index / 5}.5,0,5\n"));

        Assert.Contains(
            "Multiply them by 15", Assert.Throws<BadInputException>(() => Read("ra,dec,v\n" + rows)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_CutLineOfHipparcos_IsNamed()
    {
        string[] fields = [.. Enumerable.Repeat(" ", 78)];
        (fields[1], fields[8], fields[9]) = ("1", "10", "20");

        Assert.Contains(
            "s.csv, line 2: it has 5 fields",
            Assert.Throws<BadInputException>(() => Read($"{string.Join('|', fields)}\nH|2| | |x\n")).Message, StringComparison.Ordinal);
    }

    private static StarCatalogueFile Read(string text) => StarCatalogueReader.Read(new StringReader(text), "s.csv", null);

    private static void AssertPlace(double rightAscension, double declination, Star star)
    {
        Assert.Equal(1.0, star.Direction.Length, 1e-15);
        double ra = double.RadiansToDegrees(Math.Atan2(star.Direction.Y, star.Direction.X));
        Assert.Equal(rightAscension, ra < 0.0 ? ra + 360.0 : ra, 1e-11);
        Assert.Equal(
            declination,
            double.RadiansToDegrees(Math.Atan2(star.Direction.Z, double.Hypot(star.Direction.X, star.Direction.Y))), 1e-11);
    }
}
