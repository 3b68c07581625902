using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class HapkeReflectanceTests
{
    /// <summary>
    /// 1, relative: in the plane of Sun and viewer the azimuth is 0 or pi and known from its haversine to the square root of a rounding
    /// only, 1e-8 rad; near the zenith, where it no longer matters, to less.
    /// </summary>
    private const double InPlane = 1e-7;

    /// <summary>1, relative: dozens of roundings.</summary>
    private const double Rounding = 1e-12;

    /// <summary>The sets of tests/reference/reflectance.py, in its order.</summary>
    private static readonly HapkeParameters[] Sets =
    [
        new(),
        new(0.21, 0.29, 0.39, 1.0, 0.07, 0.0),
        new(0.95, 0.1, -0.4, 0.0, 1.0, 40.0),
        new(1.0, 0.6, 0.9, 3.0, 0.01, 10.0),
    ];

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void RadianceFactor_OfTheReference_IsItsNumber(int set)
    {
        HapkeReflectance law = new(Sets[set]);
        Assert.All(ReflectanceRow.All, row =>
        {
            double expected = row.RadianceFactors[ReflectanceRow.FirstHapkeColumn + set];
            double actual = law.RadianceFactor(row.CosIncidence, row.CosEmission, row.PhaseHaversine);
            Assert.InRange(actual, expected * (1.0 - InPlane), expected * (1.0 + InPlane));
        });
    }

    [Fact]
    public void RadianceFactor_OutOfThePlane_HasTwelveDigits()
    {
        HapkeReflectance law = new(new HapkeParameters());
        ReflectanceRow row = ReflectanceRow.All.Single(r => r is { CosIncidence: 0.5, CosEmission: 0.5 });
        double expected = row.RadianceFactors[ReflectanceRow.FirstHapkeColumn];

        Assert.Equal(expected, law.RadianceFactor(row.CosIncidence, row.CosEmission, row.PhaseHaversine), expected * Rounding);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void RadianceFactor_AnyGeometry_IsFiniteAndNotNegative(int set)
    {
        HapkeReflectance law = new(Sets[set]);
        Prop.ForAll(Geometries.Any, at => law.RadianceFactor(at.CosIncidence, at.CosEmission, at.PhaseHaversine) is >= 0.0 and < 100.0)
            .Check(Geometries.Seeded);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void RadianceFactors_OfTheReference_AreItsNumbers(int set)
    {
        HapkeReflectance law = new(Sets[set]);
        double[] actual = new double[ReflectanceRow.All.Length];
        law.RadianceFactors(
            ReflectanceRow.All.Select(row => row.CosIncidence).ToArray(),
            ReflectanceRow.All.Select(row => row.CosEmission).ToArray(),
            ReflectanceRow.All.Select(row => row.PhaseHaversine).ToArray(),
            actual);

        for (int i = 0; i < actual.Length; i++)
        {
            double expected = ReflectanceRow.All[i].RadianceFactors[ReflectanceRow.FirstHapkeColumn + set];
            Assert.InRange(actual[i], expected * (1.0 - InPlane), expected * (1.0 + InPlane));
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void RadianceFactors_AnyGeometry_AreThoseOfSinglePoints(int set)
    {
        HapkeReflectance law = new(Sets[set]);
        Prop.ForAll(Geometries.Any, at =>
        {
            double expected = law.RadianceFactor(at.CosIncidence, at.CosEmission, at.PhaseHaversine);
            double[] actual = new double[9];
            law.RadianceFactors(
                Enumerable.Repeat(at.CosIncidence, 9).ToArray(), Enumerable.Repeat(at.CosEmission, 9).ToArray(),
                Enumerable.Repeat(at.PhaseHaversine, 9).ToArray(), actual);

            return Math.Abs(actual[0] - expected) <= Rounding * expected && actual[8] == actual[0];
        }).Check(Geometries.Seeded);
    }

    [Theory]
    [InlineData(-0.1, 0.5)]
    [InlineData(0.5, 0.0)]
    public void RadianceFactors_BelowTheHorizon_AreZero(double cosIncidence, double cosEmission)
    {
        double[] actual = [7.0];
        new HapkeReflectance(new HapkeParameters()).RadianceFactors([cosIncidence], [cosEmission], [0.5], actual);
        Assert.Equal([0.0], actual);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void RadianceFactor_SunAndViewerChangePlaces_IsReciprocal(int set)
    {
        HapkeReflectance law = new(Sets[set]);
        Prop.ForAll(Geometries.Any.Filter(at => Math.Min(at.CosIncidence, at.CosEmission) > 1e-6), at =>
        {
            double there = law.RadianceFactor(at.CosIncidence, at.CosEmission, at.PhaseHaversine) / at.CosIncidence;
            double back = law.RadianceFactor(at.CosEmission, at.CosIncidence, at.PhaseHaversine) / at.CosEmission;
            return Math.Abs(there - back) <= Rounding * there;
        }).Check(Geometries.Seeded);
    }

    [Fact]
    public void RadianceFactor_NoRoughness_CastsNoShadows()
    {
        // One isotropic scattering of w = 1e-9 grains without surge is Lommel-Seeliger: w / 4 mu0 / (mu0 + mu).
        HapkeReflectance law = new(new HapkeParameters(1e-9, 0.0, 0.0, 0.0, 1.0, 0.0));

        Assert.Equal(0.25e-9 * 0.2 / 0.9, law.RadianceFactor(0.2, 0.7, 0.6), 1e-17);
    }

    [Fact]
    public void RadianceFactor_OppositionSurge_HalvesAtItsWidth()
    {
        // Grains that scatter alike to all sides, seen in the zenith: I/F less its part without surge is w / 8 B0 / (1 + tan(g/2) / h).
        HapkeReflectance with = new(new HapkeParameters(0.01, 0.0, 0.0, 2.0, 0.1, 0.0));
        HapkeReflectance without = new(new HapkeParameters(0.01, 0.0, 0.0, 0.0, 0.1, 0.0));
        double haversine = 0.01 / 1.01;
        double cosine = 1.0 - (2.0 * haversine);

        double surge = with.RadianceFactor(cosine, 1.0, haversine) - without.RadianceFactor(cosine, 1.0, haversine);

        Assert.Equal(0.01 / 4.0 * cosine / (1.0 + cosine) * 1.0, surge, 1e-15);
    }

    [Fact]
    public void WithNormalAlbedo_SunAndViewerInTheZenith_IsTheAlbedo()
    {
        HapkeReflectance scaled = HapkeReflectance.WithNormalAlbedo(new HapkeParameters(), 0.64);
        HapkeReflectance own = new(new HapkeParameters());

        Assert.Equal(0.64, scaled.RadianceFactor(1.0, 1.0, 0.0), 14);
        Assert.Equal(
            scaled.RadianceFactor(0.3, 0.8, 0.4) / own.RadianceFactor(0.3, 0.8, 0.4),
            scaled.RadianceFactor(0.9, 0.1, 0.4) / own.RadianceFactor(0.9, 0.1, 0.4),
            13);
    }

    [Fact]
    public void WithNormalAlbedo_BlackGrains_IsBadInput() =>
        Assert.Throws<BadInputException>(() => HapkeReflectance.WithNormalAlbedo(new HapkeParameters(singleScatteringAlbedo: 0.0), 0.64));
}
