using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

/// <summary>The surface of several models, over all of its facets.</summary>
public sealed class NestedTerrainTests
{
    public static TheoryData<string> Scenes => [.. NestedScenes.Names];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Surface_AllFacets_AreOneClosedSurface(string name) => Assert.Null(NestedScenes.FacetsOf(name).FindFlaw());

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Surface_Facets_FaceOutwards(string name) => Assert.DoesNotContain(
        NestedScenes.FacetsOf(name).Facets, facet => !(Vector3D.Dot(facet.A, Vector3D.Cross(facet.B, facet.C)) > 0.0));

    /// <summary>The finest model that has data wins: each of its samples is a vertex with its own radius.</summary>
    [Theory]
    [MemberData(nameof(Scenes))]
    public void Surface_FinestModel_HasItsOwnHeights(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        GridPatch finest = terrain.Surface.Parts[^1];
        ITerrainGrid own = terrain.Models[^1];
        GridWindow window = own.Window;
        double[] radius = new double[1];
        int inside = 0;
        for (int line = window.FirstLine; line < window.EndLine - 1; line++)
        {
            for (int sample = window.FirstSample; sample < window.EndSample - 1; sample++)
            {
                if (own.MayHaveGaps)
                {
                    continue;
                }

                own.ReadRadii(line, sample, radius);
                Assert.True(finest.Has(line, sample));
                Assert.Equal(finest.Vertex(line, sample, radius[0]), finest.Corners(line, sample).NorthWest);
                inside++;
            }
        }

        Assert.True(inside > 0 || own.MayHaveGaps);
    }

    [Fact]
    public void Surface_ModelsInAnotherOrder_IsTheSame()
    {
        IReadOnlyList<ITerrainGrid> models = NestedScenes.ModelsOf("five");
        AllFacets one = NestedScenes.FacetsOf("five");
        AllFacets other = new(new NestedTerrain(models.Reverse()));
        Assert.Equal(one.Facets, other.Facets);
    }

    /// <summary>Where a model is without data the surface is that of the coarser one, and its facets cover the hole.</summary>
    /// <summary>Maps of one name from two folders: their places decide, then where they have data, then their heights.</summary>
    [Theory]
    [InlineData(1, 0, 100.0)]
    [InlineData(0, 7, 100.0)]
    [InlineData(0, 0, 100.5)]
    public void Models_OfOneName_AreInOneOrder(int shift, int gaps, double height)
    {
        GridWithGaps Map(int poleSample, int hole, double lastHeight) => new(
            new PolarFunctionGrid(
                new PolarStereographic(IsSouth: true, 4000.0, 19.5, poleSample + 0.5), 40, 40,
                (line, sample) => (line, sample) is (39, 39) ? lastHeight : 100.0),
            (line, sample) => line == 20 && sample < hole);
        ITerrainGrid[] models = [FunctionGrid.Rugged(1), Map(19, 0, 100.0), Map(19 + shift, gaps, height)];

        Assert.Equal(new NestedTerrain(models).Models, new NestedTerrain(models.Reverse()).Models);
    }

    /// <summary>The same maps with each other's names are in the same order: names say nothing.</summary>
    [Fact]
    public void Models_OfOneResolution_AreOrderedByWhatTheyHold()
    {
        PolarFunctionGrid high = new(new PolarStereographic(IsSouth: true, 4000.0, 19.5, 19.5), 40, 40, (_, _) => 100.0);
        PolarFunctionGrid low = new(new PolarStereographic(IsSouth: true, 4000.0, 19.5, 19.5), 40, 40, (_, _) => 50.0);
        double LastHeight(string highName, string lowName)
        {
            double[] radius = new double[1];
            new NestedTerrain([FunctionGrid.Rugged(1), new NamedGrid(high, highName), new NamedGrid(low, lowName)])
                .Models[2].ReadRadii(3, 3, radius);
            return radius[0];
        }

        Assert.Equal(LastHeight("A", "B"), LastHeight("B", "A"));
    }

    [Fact]
    public void Surface_WideHole_ShowsTheCoarserModelsCells()
    {
        FunctionGrid moon = FunctionGrid.Rugged(4);
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 2000.0, 160, 79.5, 79.5);
        GridWithGaps holed = new(map, (line, sample) => line is > 40 and < 120 && sample is > 40 and < 120);
        SurfaceModel surface = new NestedTerrain([holed, moon]).Surface;
        Assert.True(surface.Parts[0].Has(718, 77)); // beside the pole, in the middle of the hole
        Assert.False(surface.Parts[1].Has(79, 79));
        Assert.True(surface.Parts[1].Has(20, 20));
        Assert.False(surface.Parts[0].Has(718 - 16, 77)); // 4 degrees from the pole, where the map has data
    }

    [Fact]
    public void RadiusBelow_AnyDirection_IsOnTheFacetThatTheBruteForceFinds()
    {
        NestedTerrain terrain = NestedScenes.Named("five");
        AllFacets all = NestedScenes.FacetsOf("five");
        Random random = new(20120301);
        for (int number = 0; number < 60; number++)
        {
            double fromPole = Math.Pow(10.0, (random.NextDouble() * 4.0) - 4.0);
            double longitude = random.NextDouble() * 2.0 * Math.PI;
            Vector3D direction = new(
                Math.Sin(fromPole) * Math.Cos(longitude), Math.Sin(fromPole) * Math.Sin(longitude), -Math.Cos(fromPole));
            Vector3D top = 1.8e6 * direction;
            (_, Vector3D point, _) = all.FirstHit(top, -top)!.Value;
            // m: thousands of ulps, on facets that are narrow at the pole
            Assert.InRange(TerrainHeight.RadiusBelow(terrain, direction) - point.Length, -1e-6, 1e-6);
        }
    }

    [Fact]
    public void Constructor_TwoOfTheWholeMoon_SaysWhichIsHidden() => Assert.Contains(
        "Leave that one out",
        Assert.Throws<BadInputException>(() => new NestedTerrain([FunctionGrid.Rugged(1), FunctionGrid.Rugged(4)])).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Surface_ModelUnderAFinerOne_SaysThatNothingIsSeen()
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 5000.0, 40, 19.5, 19.5);
        PolarFunctionGrid over = PolarFunctionGrid.Rugged(true, 4000.0, 90, 44.5, 44.5);
        NestedTerrain terrain = new([FunctionGrid.Rugged(1), map, over]);
        Assert.Contains("would be seen", Assert.Throws<BadInputException>(() => terrain.Surface).Message, StringComparison.Ordinal);
    }

    private sealed class NamedGrid(ITerrainGrid grid, string name) : ITerrainGrid
    {
        public string ProductId => name;

        public MapProjection Projection => grid.Projection;

        public int Lines => grid.Lines;

        public int Samples => grid.Samples;

        public void ReadRadii(int line, int firstSample, Span<double> radii) => grid.ReadRadii(line, firstSample, radii);
    }
}
