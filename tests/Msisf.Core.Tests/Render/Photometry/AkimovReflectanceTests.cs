using System.Globalization;
using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class AkimovReflectanceTests
{
    /// <summary>Relative: what the law's coordinates lose of cosines with 53 bits one degree off the limb, with a margin of ten.</summary>
    private const double OfTheReference = 1e-12;

    [Fact]
    public void RadianceFactor_OfTheReference_IsItsNumber()
    {
        // python3 tests/reference/akimov.py
        double[][] rows =
        [
            .. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "akimov.tsv")).Skip(1)
                .Select(line => line.Split('\t').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray()),
        ];
        double?[] slopes = [null, 0.0, 2.5];

        Assert.Equal(200, rows.Length);
        Assert.All(rows, row => Assert.All(
            slopes,
            (slope, column) =>
            {
                double expected = row[3 + column];
                Assert.Equal(
                    expected, new AkimovReflectance(1.0, slope).RadianceFactor(row[0], row[1], row[2]), OfTheReference * expected);
            }));
    }

    [Fact]
    public void RadianceFactor_AtOpposition_IsTheAlbedoEverywhere()
    {
        AkimovReflectance law = new(0.3);
        Assert.All([1.0, 0.5, 1e-3, 1e-9], cosine => Assert.Equal(0.3, law.RadianceFactor(cosine, cosine, 0.0), Rounding.OfUnits));
    }

    [Theory]
    [InlineData(30.0)]
    [InlineData(90.0)]
    [InlineData(150.0)]
    public void RadianceFactor_TowardsTheLimb_GoesToItsFiniteLimit(double phaseDegrees)
    {
        // On the photometric equator the ratio of cosines goes to pi / (pi - g), by l'Hospital's rule.
        double phase = double.DegreesToRadians(phaseDegrees);
        double limit = Math.Cos(0.5 * phase) * Math.PI / (Math.PI - phase);
        AkimovReflectance law = new(1.0, 0.0);
        double haversine = Math.Pow(Math.Sin(0.5 * phase), 2);

        // One nanoradian off the limb: the law's slope there is of order 1.
        Assert.Equal(limit, law.RadianceFactor(Math.Sin(phase), 1e-9, haversine), 1e-8);
        Assert.Equal(limit, law.RadianceFactor(Math.Sin(phase), 1e-300, haversine), Rounding.OfChains);
    }

    [Fact]
    public void RadianceFactor_TowardsTheTerminator_GoesToZero() =>
        // some times the cosine of incidence
        Assert.InRange(new AkimovReflectance(1.0).RadianceFactor(1e-9, Math.Sin(1.0), Math.Pow(Math.Sin(0.5), 2)), 0.0, 1e-8);

    [Fact]
    public void RadianceFactor_AnyGeometry_IsFiniteAndNotNegative()
    {
        AkimovReflectance law = new(1.0);
        Prop.ForAll(
            Geometries.Any,
            at => law.RadianceFactor(at.CosIncidence, at.CosEmission, at.PhaseHaversine) is >= 0.0 and < double.PositiveInfinity)
            .Check(Geometries.Seeded);
    }

    [Theory]
    [InlineData(-0.1)]
    [InlineData(10.5)]
    [InlineData(double.NaN)]
    public void Constructor_SlopeOutOfRange_IsBadInput(double slope) =>
        Assert.StartsWith(
            "akimov parameter mu (rad^-1) is ",
            Assert.Throws<BadInputException>(() => new AkimovReflectance(0.5, slope)).Message,
            StringComparison.Ordinal);
}
