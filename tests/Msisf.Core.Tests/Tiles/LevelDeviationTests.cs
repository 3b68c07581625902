using Msisf.Core.Lod;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public class LevelDeviationTests
{
    /// <summary>m: of cells of 4 px/deg, R (1 - cos(1.01 * 0.125 * sqrt 2 degrees)).</summary>
    private const double Sagitta = 8.44;

    private static readonly SurfacePart Part = SurfacePart.Whole(new TileId(0, 15), 1);

    [Fact]
    public void Of_TheModelItself_IsNone() =>
        Assert.Equal(0.0, LevelDeviation.Of(LodLevels.Open(FunctionGrid.Rough(8)), SurfacePart.Whole(new TileId(0, 15))));

    [Fact]
    public void Of_EvenSlope_IsTheFacetsSagittaAlone()
    {
        LodLevels levels = LodLevels.Open(FunctionGrid.OfHeights(8, (line, sample) => (0.5 * line) + (0.25 * sample)));

        Assert.Equal(Sagitta, LevelDeviation.Of(levels, Part), 0.05); // m: the slope of 0.5 m a line turns the facets
    }

    /// <summary>
    /// One sample of height H makes a coarse sample of H / 4. The north-western of the four lies on the diagonal, a quarter of a cell from
    /// the coarse sample, where the facet is 3/4 of H / 4 high; the north-eastern at (3/4, 1/4) on the facet (NW, SE, NE) of the next cell,
    /// where it is H / 4 * 1/2.
    /// </summary>
    [Theory]
    [InlineData(0, 0, 1.0 - 0.1875)]
    [InlineData(0, 1, 1.0 - 0.125)]
    [InlineData(1, 0, 1.0 - 0.125)]
    [InlineData(1, 1, 1.0 - 0.1875)]
    public void Of_OneSpike_IsItsHeightOverTheFacet(int line, int sample, double expected)
    {
        LodLevels levels = LodLevels.Open(FunctionGrid.OfHeights(8, (i, j) => (i, j) == (700 + line, 140 + sample) ? 1000.0 : 0.0));

        // m: the slope of 0.5 m a line turns the facets
        Assert.Equal((1000.0 * expected) + Sagitta, LevelDeviation.Of(levels, Part), 0.05);
    }

    [Fact]
    public void Of_PolarPartOverThePrimeMeridian_ReadsWithinTheModel() =>
        Assert.InRange(LevelDeviation.Of(LodLevels.Open(FunctionGrid.Rough(8)), SurfacePart.Whole(new TileId(85, 0), 2)), 1000.0, 20_000.0);
}
