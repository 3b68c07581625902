using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

public sealed class BorderMisfitTests
{
    /// <summary>m: the facets of a sphere with 8 px/deg lie up to a metre below it.</summary>
    private const double Sagitta = 1.1;

    /// <summary>A map 20 m above the Moon, but for one sample of its border and one of its inside.</summary>
    [Theory]
    [InlineData(20.0, 120.0)]
    [InlineData(-20.0, -120.0)]
    [InlineData(20.0, -120.0)]
    public void BorderMisfits_MapOffTheMoon_IsThatOfTheOutermostSamples(double height, double worst)
    {
        PolarFunctionGrid map = new(new PolarStereographic(IsSouth: true, 1000.0, 49.5, 49.5), 100, 100, (line, sample) =>
            (line, sample) is (70, 99) ? worst : (line, sample) is (50, 50) ? 900.0 : height);

        BorderMisfit misfit = Assert.Single(new NestedTerrain([map, new FunctionGrid(8, (_, _) => 1_737_400.0)]).BorderMisfits())!.Value;

        // 396 samples lie on the border.
        Assert.InRange(misfit.Height.Mean, ((395.0 * height) + worst) / 396.0, (((395.0 * height) + worst) / 396.0) + Sagitta);
        Assert.InRange(misfit.Height.Greatest, worst, worst + Sagitta);
        Assert.InRange(misfit.Height.Rms, 20.7 - Sagitta, 20.7 + Sagitta); // of 20 m and one of 120
    }

    [Fact]
    public void BorderMisfits_AroundPlacesWithoutData_CountToo()
    {
        PolarFunctionGrid map = new(new PolarStereographic(IsSouth: true, 1000.0, 49.5, 49.5), 100, 100, (line, sample) =>
            (line, sample) is (39, 45) ? 300.0 : 0.0);
        GridWithGaps withHole = new(map, (line, sample) => line is >= 40 and < 50 && sample is >= 40 and < 50);

        NestedTerrain terrain = new([new FunctionGrid(8, (_, _) => 1_737_400.0), withHole]);
        BorderMisfit misfit = Assert.Single(terrain.BorderMisfits())!.Value;

        Assert.InRange(misfit.Height.Greatest, 300.0, 300.0 + Sagitta);
    }
}
