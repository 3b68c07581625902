using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class ReflectanceFactoryTests
{
    private static readonly Dictionary<string, double> None = [];

    [Theory]
    [InlineData("akimov")]
    [InlineData("lambert")]
    [InlineData("lommel-seeliger")]
    [InlineData("lunar-lambert")]
    [InlineData("hapke")]
    public void Create_AnyLaw_HasTheNormalAlbedoThatIsAskedFor(string law)
    {
        Assert.Equal(0.64, ReflectanceFactory.Create(law, None).RadianceFactor(1.0, 1.0, 0.0), 14);
        Assert.Equal(0.12, ReflectanceFactory.Create(law, None, 0.12).RadianceFactor(1.0, 1.0, 0.0), 14);
    }

    [Fact]
    public void Create_HapkeWithItsOwnW_HasTheBrightnessOfTheReference()
    {
        // First line of tests/golden/reflectance.tsv.
        IReflectance moon = ReflectanceFactory.Create("hapke", new Dictionary<string, double> { ["w"] = 0.32357 });
        IReflectance bright = ReflectanceFactory.Create(
            "hapke",
            new Dictionary<string, double> { ["theta"] = 10, ["h"] = 0.01, ["b0"] = 3, ["c"] = 0.9, ["b"] = 0.6, ["w"] = 1 });

        Assert.Equal(0.1889995572187419, moon.RadianceFactor(1.0, 1.0, 0.0), 15);
        Assert.Equal(5.6128510199252812, bright.RadianceFactor(1.0, 1.0, 0.0), 13);
    }

    [Fact]
    public void Create_LunarLambertWithItsWeight_UsesIt() =>
        Assert.Equal(
            0.5 * 0.2,
            ReflectanceFactory.Create("lunar-lambert", new Dictionary<string, double> { ["l"] = 0.0 }, 0.5).RadianceFactor(0.2, 0.9, 0.3),
            15);

    [Theory]
    [InlineData(
        "phong",
        "",
        0.0,
        "Reflectance law 'phong' is not known. Known laws: akimov (parameter mu), hapke (parameters w, b, c, b0, h, theta), lambert")]
    [InlineData("Lambert", "", 0.0, "Reflectance law 'Lambert' is not known.")]
    [InlineData("lambert", "l", 0.5, "Reflectance law lambert has no parameter 'l'. It has none.")]
    [InlineData("hapke", "B0", 1.0, "Reflectance law hapke has no parameter 'B0'. It has w, b, c, b0, h, theta.")]
    [InlineData("hapke", "w", 1.5, "hapke parameter w is 1.5; a number from 0 to 1 is needed.")]
    [InlineData("hapke", "b", 1.0, "hapke parameter b is 1; a number from 0 to 0.95 is needed.")]
    [InlineData("hapke", "c", -2.0, "hapke parameter c is -2; a number from -1 to 1 is needed.")]
    [InlineData("hapke", "b0", -1.0, "hapke parameter b0 is -1; a number from 0 to 10 is needed.")]
    [InlineData("hapke", "h", 0.0, "hapke parameter h is 0; a number from 0.0001 to 10 is needed.")]
    [InlineData("hapke", "theta", 61.0, "hapke parameter theta (degrees) is 61; a number from 0 to 60 is needed.")]
    [InlineData("hapke", "theta", double.NaN, "hapke parameter theta (degrees) is NaN; a number from 0 to 60 is needed.")]
    public void Create_WrongLawOrParameter_SaysWhatIsWrong(string law, string name, double value, string message)
    {
        Dictionary<string, double> parameters = name.Length == 0 ? [] : new() { [name] = value };

        BadInputException failure = Assert.Throws<BadInputException>(() => ReflectanceFactory.Create(law, parameters));

        Assert.StartsWith(message, failure.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("akimov")]
    [InlineData("lambert")]
    [InlineData("lommel-seeliger")]
    [InlineData("lunar-lambert")]
    [InlineData("hapke")]
    public void Create_AlbedoAboveOne_IsBadInput(string law) =>
        Assert.StartsWith(
            "albedo is 1.1; ",
            Assert.Throws<BadInputException>(() => ReflectanceFactory.Create(law, None, 1.1)).Message,
            StringComparison.Ordinal);

    [Fact]
    public void Create_Moon_HasTheBrightnessOfSatosMedians()
    {
        // python3 tests/reference/moon_law.py
        IReflectance moon = ReflectanceFactory.Create("moon", None);
        IReflectance violet = ReflectanceFactory.Create("moon", None, band: SpectralBand.Of(321));

        Assert.Equal(0.097835190971512899, At(moon, 30.0, 0.0, 30.0), 1e-13);
        Assert.Equal(0.045825063890022277, At(moon, 60.0, 0.0, 60.0), 1e-13);
        Assert.InRange(At(violet, 30.0, 0.0, 30.0) / At(moon, 30.0, 0.0, 30.0), 0.3, 0.5);
    }

    [Theory]
    [InlineData(30.0, 0.0, 30.0, 0.087598322788859186)] // python3 tests/reference/moon_law.py
    [InlineData(60.0, 20.0, 45.0, 0.051118477632417614)]
    [InlineData(0.0, 0.0, 0.0, 0.24833582182230244)]
    [InlineData(80.0, 70.0, 140.0, 0.007362198543372184)]
    public void Create_Nac_HasTheBrightnessOfItsFormula(double incidence, double emission, double phase, double expected) =>
        Assert.Equal(expected, At(ReflectanceFactory.Create("nac", None), incidence, emission, phase), Rounding.OfTurns);

    private static double At(IReflectance law, double incidence, double emission, double phase)
    {
        ReferenceGeometry geometry = new(incidence, emission, phase);
        return law.RadianceFactor(geometry.CosIncidence, geometry.CosEmission, geometry.PhaseHaversine);
    }

    [Theory]
    [InlineData("moon")]
    [InlineData("nac")]
    public void Create_AbsoluteLawWithAlbedo_IsBadInput(string law) =>
        Assert.Contains(
            "takes no albedo", Assert.Throws<BadInputException>(() => ReflectanceFactory.Create(law, None, 0.5)).Message,
            StringComparison.Ordinal);

    [Fact]
    public void Create_HapkeWithWAndAlbedo_IsBadInput() =>
        Assert.Contains("Leave one out.", Assert.Throws<BadInputException>(
            () =>
                ReflectanceFactory.Create("hapke", new Dictionary<string, double> { ["w"] = 0.3 }, 0.5)).Message, StringComparison.Ordinal);
}
