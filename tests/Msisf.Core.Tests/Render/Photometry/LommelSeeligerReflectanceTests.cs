using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class LommelSeeligerReflectanceTests
{
    /// <summary>1, relative: three roundings.</summary>
    private const double Rounding = 4e-16;

    [Fact]
    public void RadianceFactor_OfTheReference_IsItsNumber()
    {
        LommelSeeligerReflectance law = new(0.5);
        Assert.All(ReflectanceRow.All, row =>
        {
            double expected = 0.5 * row.RadianceFactors[ReflectanceRow.LommelSeeligerColumn];
            Assert.Equal(expected, law.RadianceFactor(row.CosIncidence, row.CosEmission, row.PhaseHaversine), Rounding * 2.0);
        });
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.1)]
    [InlineData(1e-300)]
    public void RadianceFactor_AtOpposition_IsTheSameFromDiscCentreToLimb(double cosine) =>
        Assert.Equal(0.3, new LommelSeeligerReflectance(0.3).RadianceFactor(cosine, cosine, 0.0));
}
