using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

/// <summary>Seams that are kept are those that would be made.</summary>
public sealed class SeamMemoryTests
{
    [Theory]
    [InlineData("five", 4)]
    [InlineData("crossing", 1)]
    [InlineData("gaps", 2)]
    [InlineData("north", 2)]
    public void Surface_WithKeptSeams_IsTheSame(string name, int leastGaps)
    {
        IReadOnlyList<ITerrainGrid> models = NestedScenes.ModelsOf(name);
        CountingStore store = new();
        SeamPatch first = new NestedTerrain(models, store).Surface.Seams;
        int made = store.Kept.Count;
        SeamPatch again = new NestedTerrain(models, store).Surface.Seams;

        Assert.True(made >= leastGaps, $"{made} gaps");
        Assert.Equal(made, store.Kept.Count); // none was made again
        Assert.Equal(FacetsOf(new NestedTerrain(models).Surface.Seams), FacetsOf(first));
        Assert.Equal(FacetsOf(first), FacetsOf(again));
    }

    /// <summary>The gap around the map is the same with a site in its middle, if the map's ground stays as it is.</summary>
    [Fact]
    public void Surface_OneModelMore_TakesTheOtherGaps()
    {
        IReadOnlyList<ITerrainGrid> models = NestedScenes.ModelsOf("five");
        CountingStore store = new();
        JoinUnchanged([models[1], models[0], models[3]], store);
        Assert.Equal(2, store.Kept.Count);
        JoinUnchanged([models[1], models[0], models[3], models[4]], store);
        Assert.Equal(3, store.Kept.Count);
    }

    /// <summary>A map so small that it lies within the gap around another one: what filled the whole gap does no more.</summary>
    [Fact]
    public void Surface_ModelWithinAGap_IsNotCovered()
    {
        FunctionGrid moon = FunctionGrid.Rugged(1);
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 6000.0, 90, 44.5, 44.5); // 267 km to each side
        CountingStore store = new();
        JoinUnchanged([moon, map], store);
        string[] borders = [.. Assert.Single(store.Kept).Borders];
        int within = 0;
        foreach (int kilometres in (int[])[272, 274, 282])
        {
            PolarFunctionGrid site = PolarFunctionGrid.Rugged(true, 100.0, 16, 7.5, 7.5 - (10.0 * kilometres));
            SeamPatch seams = JoinUnchanged([moon, map, site], store);
            Assert.Equal(FacetsOf(JoinUnchanged([moon, map, site], store: null)), FacetsOf(seams));
            within += borders.All(border => store.Kept[^1].Borders.Contains(border)) ? 1 : 0;
        }

        Assert.True(within > 0, "no site lay within the gap");
    }

    /// <summary>A filling that says other borders, or corners that there are not, is not taken.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Surface_ForeignFilling_IsMadeAgain(bool hasForeignCorners)
    {
        IReadOnlyList<ITerrainGrid> models = NestedScenes.ModelsOf("polar");
        CountingStore store = new();
        SeamPatch seams = new NestedTerrain(models, store).Surface.Seams;
        GapTriangulation filling = Assert.Single(store.Kept);
        store.Known[filling.Key] = hasForeignCorners
            ? filling with { Corners = [.. filling.Corners.Select(corner => corner + 1)] }
            : filling with { Borders = [new string('0', 64), filling.Key] };

        Assert.Equal(FacetsOf(seams), FacetsOf(new NestedTerrain(models, store).Surface.Seams));
        Assert.Equal(2, store.Kept.Count);
    }

    [Fact]
    public void Find_KeptInTheOtherStore_IsFoundThere()
    {
        CountingStore files = new();
        GapTriangulation large = new("A", ["1", "2"], new int[30]);
        new SeamMemory(files, minFacets: 10).Keep(large);
        new SeamMemory(files, minFacets: 11).Keep(large with { Borders = ["3"] });

        Assert.Same(large, Assert.Single(files.Kept));
        Assert.Same(large, new SeamMemory(files).Find("A", "2"));
        Assert.Null(new SeamMemory(files).Find("A", "1"));
    }

    /// <summary>The seams of models with their own heights, as if they met.</summary>
    /// <param name="models">The coarsest first.</param>
    private static SeamPatch JoinUnchanged(IReadOnlyList<ITerrainGrid> models, ISeamStore? store)
    {
        GridPatch[] parts = [.. models.Select(model => new GridPatch(model))];
        for (int part = parts.Length - 1; part >= 0; part--)
        {
            parts[part] = parts[part].WithCells(KeptCells.Of(parts[part], parts[(part + 1)..]));
        }

        return SeamBuilder.Join(parts, store, isDelaunay: true);
    }

    private static List<(Vector3D, Vector3D, Vector3D)> FacetsOf(SeamPatch seams) =>
        [.. Enumerable.Range(0, seams.Count).Select(seams.CornersOf)];

    private sealed class CountingStore : ISeamStore
    {
        public Dictionary<string, GapTriangulation> Known { get; } = [];

        public List<GapTriangulation> Kept { get; } = [];

        public GapTriangulation? Find(string productId, string border) => Known.GetValueOrDefault(border);

        public void Keep(GapTriangulation filling)
        {
            Known[filling.Key] = filling;
            Kept.Add(filling);
        }
    }
}
