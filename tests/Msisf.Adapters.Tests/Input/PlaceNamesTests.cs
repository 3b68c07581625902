using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Input;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Navigation;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public sealed class PlaceNamesTests
{
    [Theory]
    [InlineData("Tycho", "Tycho")]
    [InlineData("tycho a", "Tycho A")]
    [InlineData("APOLLO11", "Apollo 11")]
    [InlineData("chang\u2019e 4", "Chang'e 4")]
    [InlineData("becvar", "Be\u010Dv\u00E1\u0159")]
    [InlineData("Bečvář", "Bečvář")]
    [InlineData("engelhardt b", "Engel'gardt (Engelhardt) B")]
    [InlineData("Engelgardt B", "Engel'gardt (Engelhardt) B")]
    [InlineData("mare  imbrium", "Mare Imbrium")]
    [InlineData("mee s", "Mee S")]
    [InlineData("mees", "Mees")]
    public void Find_AnySpelling_IsThePlace(string name, string expected) => Assert.Equal(expected, PlaceNames.Find(name).Name);

    [Theory]
    [InlineData("Tyco", "did you mean Tycho?")]
    [InlineData("Imbrium", "did you mean Mare Imbrium (mare, 34.7244,345.091)")]
    [InlineData("Zzzzzzzz", "is not a named place of the Moon. msis places lists them.")]
    public void Find_UnknownName_SaysWhatMayBeMeant(string name, string expected) =>
        Assert.Contains(expected, Assert.Throws<BadInputException>(() => PlaceNames.Find(name)).Message, StringComparison.Ordinal);

    /// <summary>A name that a message or msis places gives is a place to look at and to be over, and finds itself.</summary>
    [Fact]
    public void All_EachName_IsTakenWhereAPlaceIs() => Assert.All(PlaceNames.All, place =>
    {
        Assert.Same(place, PlaceNames.Find(place.Name));
        SurfacePlace expected = new(place.Latitude, place.Longitude, 100.0, false);
        Assert.Equal(expected, PointingText.ParsePosition($"{place.Name},100", CelestialBody.Moon));
        Assert.Equal(expected, PointingText.ParseTarget($"{place.Name},100", CelestialBody.Moon).Target);
        Assert.Equal(BoresightKind.Place, PointingText.ParseTarget(place.Name, CelestialBody.Moon).Kind);
        Assert.InRange(place.Longitude, 0.0, Math.BitDecrement(360.0));
    });

    /// <summary>Also names that begin as the words do.</summary>
    [Theory]
    [InlineData("Tycho")]
    [InlineData("Sundman")]
    [InlineData("sundman j")]
    [InlineData("Nadiria")]
    public void Parse_NameWithAnotherBody_IsRefused(string name)
    {
        CelestialBody mars = CelestialBody.Find("MARS")!;
        const string expected = "the named places are the Moon's, but Mars is drawn. Give latitude and longitude.";
        Assert.Contains(
            expected, Assert.Throws<BadInputException>(() => PointingText.ParsePosition($"{name},100", mars)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            expected, Assert.Throws<BadInputException>(() => PointingText.ParseTarget(name, mars)).Message, StringComparison.Ordinal);
        Assert.Equal(BoresightKind.Sun, PointingText.ParseTarget("sun", mars).Kind);
    }

    /// <summary>Middles and diameters of the craters of Head et al. (2010), measured by others and without names.</summary>
    [RequiresFact(Part.Craters)]
    public void All_LargeCraters_AreThereInTheCatalogueOfHead()
    {
        IReadOnlyList<Crater> head = CraterCatalogueReader.ReadAll(TestParts.HeadCraters!, MoonConstants.ReferenceRadius);
        NamedPlace[] large = [.. PlaceNames.All.Where(place => place is { Kind: "crater", Diameter: > 40e3 and < 150e3 })];
        int found = large.Count(place => head.Any(crater =>
            Math.Abs(crater.LatitudeDegrees - place.Latitude) < 1.0 && Math.Abs(crater.Diameter - place.Diameter) < 0.3 * place.Diameter
            && Math.Abs(Math.IEEERemainder(crater.LongitudeDegrees - place.Longitude, 360.0)) < 1.0 / Math.Cos(double.DegreesToRadians(
                crater.LatitudeDegrees))));

        Assert.InRange(found / (double)large.Length, 0.8, 1.0); // the catalogue leaves out some eroded ones
    }

    /// <summary>Values of the IAU's Gazetteer and of LROC's page on Chang'e 6, typed from there.</summary>
    [Theory]
    [InlineData("Copernicus", 9.62, 339.92, 96.07)]
    [InlineData("Tsiolkovskiy", -20.38, 128.97, 184.39)]
    [InlineData("Mare Crisium", 16.18, 59.1, 555.92)]
    [InlineData("Chang'e 6", -41.6385, 206.0148, 0.0)]
    public void Find_WellKnownPlaces_LieWhereTheIauSays(string name, double latitude, double longitude, double kilometres)
    {
        NamedPlace place = PlaceNames.Find(name);

        Assert.Equal(latitude, place.Latitude, 0.01);
        Assert.Equal(longitude, place.Longitude, 0.01);
        Assert.Equal(kilometres, place.Diameter / 1000.0, 0.01 * kilometres);
    }

    [Fact]
    public void Near_Apollo11_HasSurveyor5AfterItsOwnSite()
    {
        NamedPlace apollo = PlaceNames.Find("Apollo 11");
        (NamedPlace place, double distance) = PlaceNames.Near(apollo.Latitude, apollo.Longitude)
            .First(near => near.Place.Kind == "landing site" && near.Place != apollo);

        Assert.Equal("Surveyor 5", place.Name);
        Assert.InRange(distance, 24e3, 26e3); // 25 km: the Apollo 11 Mission Report
    }

    [Fact]
    public void Search_PartOfAName_HasItsCraterFirst()
    {
        IReadOnlyList<NamedPlace> found = PlaceNames.Search("TYCHO");

        Assert.Equal("Tycho", found[0].Name);
        Assert.True(found.Count > 10, $"{found.Count} places");
        Assert.Throws<BadInputException>(() => PlaceNames.Search("Zzzzzzzz"));
    }

    [Fact]
    public void ParsePosition_NameAndHeight_IsThePlace() =>
        Assert.Equal(new SurfacePlace(-43.2958, 348.785, 80000.0, false), PointingText.ParsePosition("Tycho,80000", CelestialBody.Moon));

    [Fact]
    public void ParseTarget_NameAlone_IsItsGround()
    {
        CameraPointing pointing = PointingText.ParseTarget("tycho", CelestialBody.Moon);

        Assert.Equal(BoresightKind.Place, pointing.Kind);
        Assert.Equal(new SurfacePlace(-43.2958, 348.785, 0.0, true), pointing.Target);
        Assert.Equal(100.0, PointingText.ParseTarget("tycho,terrain+100", CelestialBody.Moon).Target.Height);
    }

    [Theory]
    [InlineData("Tycho")]
    [InlineData("Tycho,1,2,3")]
    [InlineData("Tyco,80000")]
    public void ParsePosition_WrongName_IsRefused(string text) =>
        Assert.Throws<BadInputException>(() => PointingText.ParsePosition(text, CelestialBody.Moon));
}
