using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class LambertReflectanceTests
{
    [Fact]
    public void RadianceFactor_OfTheReference_IsItsNumber()
    {
        LambertReflectance law = new(0.5);
        Assert.All(ReflectanceRow.All, row => Assert.Equal(
            0.5 * row.RadianceFactors[ReflectanceRow.LambertColumn],
            law.RadianceFactor(row.CosIncidence, row.CosEmission, row.PhaseHaversine)));
    }
}
