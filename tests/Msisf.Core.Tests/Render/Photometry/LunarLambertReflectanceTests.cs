using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class LunarLambertReflectanceTests
{
    /// <summary>1: the weight's terms reach 10 and are rounded a few times.</summary>
    private const double Rounding = 2e-14;

    [Fact]
    public void RadianceFactor_OfTheReference_IsItsNumber()
    {
        LunarLambertReflectance law = new(1.0);
        Assert.All(ReflectanceRow.All, row => Assert.Equal(
            row.RadianceFactors[ReflectanceRow.LunarLambertColumn],
            law.RadianceFactor(row.CosIncidence, row.CosEmission, row.PhaseHaversine),
            Rounding));
    }

    [Fact]
    public void RadianceFactor_WeightAtItsEnds_IsLambertOrLommelSeeliger()
    {
        Assert.Equal(0.3 * 0.5, new LunarLambertReflectance(0.3, 0.0).RadianceFactor(0.5, 0.25, 0.4), 15);
        Assert.Equal(0.3 * 4.0 / 3.0, new LunarLambertReflectance(0.3, 1.0).RadianceFactor(0.5, 0.25, 0.4), 15);
    }

    [Fact]
    public void RadianceFactor_AnyGeometry_IsFiniteAndNotNegative()
    {
        LunarLambertReflectance law = new(1.0);
        Prop.ForAll(Geometries.Any, at => law.RadianceFactor(at.CosIncidence, at.CosEmission, at.PhaseHaversine) is >= 0.0 and <= 2.0)
            .Check(Geometries.Seeded);
    }

    [Theory]
    [InlineData(-0.1)]
    [InlineData(1.1)]
    [InlineData(double.NaN)]
    public void Constructor_WeightOutOfRange_IsBadInput(double weight) =>
        Assert.StartsWith(
            "lunar-lambert parameter l is ",
            Assert.Throws<BadInputException>(() => new LunarLambertReflectance(0.5, weight)).Message,
            StringComparison.Ordinal);
}
