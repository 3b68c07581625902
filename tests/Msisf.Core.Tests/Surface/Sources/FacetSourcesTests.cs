using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

public sealed class FacetSourcesTests
{
    /// <summary>A facet is measured if its corners have their models' own radii, and blended if one has another.</summary>
    [Theory]
    [InlineData("five")]
    [InlineData("gaps at 02")]
    [InlineData("meridian")]
    public void Of_AllFacets_TellsWhichHaveTheirModelsRadii(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        FacetSources sources = new(terrain);
        Dictionary<FacetSource, int> counts = [];
        foreach ((FacetId facet, _, _, _) in NestedScenes.FacetsOf(name).Facets)
        {
            (int model, FacetSource source) = sources.Of(facet);
            counts[source] = counts.GetValueOrDefault(source) + 1;
            (int Part, int Line, int Sample)[] corners =
                [.. Enumerable.Range(0, 3).Select(corner => terrain.Surface.Patches[facet.Part].VertexOf(facet, corner))];
            Assert.Equal(corners.Max(corner => corner.Part), model);
            if (facet.Part == terrain.PartCount)
            {
                Assert.Equal(FacetSource.Seam, source);
            }
            else if (corners.All(corner => corner.Line >= 0 && corner.Line < terrain.Models[facet.Part].Lines)) // no pole
            {
                bool isOwn = corners.All(corner => RadiusOf(terrain.Models[facet.Part], corner)
                    == RadiusOf(terrain.Surface.Parts[facet.Part].Grid, corner));
                Assert.Equal(isOwn ? FacetSource.Measured : FacetSource.Blended, source);
            }
        }

        Assert.Equal([FacetSource.Measured, FacetSource.Blended, FacetSource.Seam], counts.Keys.Order());
    }

    [Fact]
    public void Of_OneModel_IsMeasured() =>
        Assert.Equal((0, FacetSource.Measured), new FacetSources(FunctionGrid.Rugged(1)).Of(new FacetId(20, 3, FacetHalf.NorthEast)));

    private static double RadiusOf(ITerrainGrid grid, (int Part, int Line, int Sample) corner)
    {
        double[] radius = new double[1];
        new FacetMesh(grid).ReadRadii(corner.Line, corner.Sample, radius);
        return radius[0];
    }
}
