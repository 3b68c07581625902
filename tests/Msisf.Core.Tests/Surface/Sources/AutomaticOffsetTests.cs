using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

public sealed class AutomaticOffsetTests
{
    /// <summary>The site meets the map around it where that is once it is raised; the order in which they are given is kept.</summary>
    [Fact]
    public void Of_MapsInEachOther_MeetWhatIsAroundThemInTheMean()
    {
        PolarFunctionGrid map = new(new PolarStereographic(IsSouth: true, 1000.0, 49.5, 49.5), 100, 100, (_, _) => 60.0);
        PolarFunctionGrid site = new(
            new PolarStereographic(IsSouth: true, 100.0, 49.5, 49.5), 100, 100, (line, _) => line < 50 ? 20.0 : 40.0);
        FunctionGrid moon = new(8, (_, _) => 1_737_400.0);

        IReadOnlyList<double> both = AutomaticOffset.Of([site, moon, map], grid => grid != moon);
        IReadOnlyList<double> one = AutomaticOffset.Of([site, moon, map], grid => grid == site);

        Assert.InRange(both[0], -31.1, -30.0); // facets of a sphere with 8 px/deg lie up to a metre below it
        Assert.Equal(0.0, both[1]);
        Assert.InRange(both[2], -61.1, -60.0);
        Assert.InRange(one[0], 29.8, 30.0);
        Assert.Equal([0.0, 0.0], one.Skip(1));
        OffsetGrid raised = new(site, one[0]);
        Assert.InRange(new NestedTerrain([moon, map, raised]).BorderMisfits().Last()!.Value.Height.Mean, -1e-6, 1e-6);
    }
}
