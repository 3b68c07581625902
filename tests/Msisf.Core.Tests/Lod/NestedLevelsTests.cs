using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Lod;

/// <summary>Which surfaces combinations of levels give. That they are closed is counted with the other scenes of several models.</summary>
public sealed class NestedLevelsTests
{
    [Fact]
    public void Terrain_AllLevelsOfTheModels_IsTheSurfaceOfTheModels()
    {
        NestedLevels levels = NestedScenes.LevelsOf("five");
        Assert.Same(levels.Scene, levels.Terrain([0, 0, 0, 0, 0]));
    }

    [Fact]
    public void Terrain_OneLeftOut_KeepsTheNumbersOfTheOthers()
    {
        NestedTerrain terrain = NestedScenes.Named("five at 0-102");

        Assert.Equal(5, terrain.PartCount);
        Assert.Equal([null, 1200.0, 100.0, 80.0], terrain.DrawnResolutions.Skip(1).Select(drawn => drawn?.MetresPerPixel));
        Assert.Equal([false, true, false, false, false], terrain.Parts.Select(part => part.IsLeftOut));
        SeamPatch seams = terrain.Surface.Seams;
        Assert.All(Enumerable.Range(0, seams.Count), facet => Assert.NotEqual(1, seams.VertexOf(facet, 0).Part));
    }

    /// <summary>What was drawn before, and what is taken from it, makes no difference.</summary>
    [Fact]
    public void Terrain_AfterOtherFrames_IsThatOfAFirstFrame()
    {
        int?[] wanted = [0, 0, 1, 0, 1];
        NestedTerrain alone = NestedScenes.NewLevelsOf(new NestedTerrain(NestedScenes.ModelsOf("five"))).Terrain(wanted);

        NestedLevels levels = NestedScenes.NewLevelsOf(new NestedTerrain(NestedScenes.ModelsOf("five").Reverse(), new SeamMemory()));
        foreach (int?[] before in (int?[][])[[0, 0, 0, 0, 0], [0, 0, 1, 0, 2], [0, 0, 1, 1, 1], [0, 0, 1, null, null], [0, 1, 1, 0, 1]])
        {
            _ = levels.Terrain(before).Surface;
        }

        NestedTerrain later = levels.Terrain(wanted);
        Assert.Equal(CornersOf(alone.Surface.Seams), CornersOf(later.Surface.Seams));
        for (int part = 1; part < 5; part++)
        {
            Assert.Equal(RadiiOf(alone.Parts[part]), RadiiOf(later.Parts[part]));
            Assert.Equal(alone.Parts[part].Kept!.Pieces, later.Parts[part].Kept!.Pieces);
        }
    }

    /// <summary>What a model gets from finer ones does not depend on their levels, only on whether they are there.</summary>
    [Fact]
    public void Terrain_CoarserModelsChanged_ModelsOfTheSameLevelHaveTheirBoundsInCommon()
    {
        NestedLevels levels = NestedScenes.NewLevelsOf(new NestedTerrain(NestedScenes.ModelsOf("five")));
        NestedTerrain one = levels.Terrain([0, 0, 0, 0, 1]);
        NestedTerrain other = levels.Terrain([0, 1, 0, 1, 1]);
        NestedTerrain without = levels.Terrain([0, 1, 0, 1, null]);

        Assert.Same(levels.Scene.Parts[3].Bounds, one.Parts[3].Bounds);
        Assert.Same(one.Parts[2].Bounds, other.Parts[2].Bounds);
        Assert.Same(one.Parts[4].Bounds, other.Parts[4].Bounds);
        Assert.NotSame(one.Parts[3].Bounds, other.Parts[3].Bounds);
        Assert.NotSame(other.Parts[2].Bounds, without.Parts[2].Bounds); // the site changes it
    }

    [Fact]
    public void Terrain_AskedForAgain_IsTheSameObject()
    {
        NestedLevels levels = NestedScenes.NewLevelsOf(new NestedTerrain(NestedScenes.ModelsOf("polar"), new SeamMemory()));
        NestedTerrain first = levels.Terrain([0, 1]);
        Assert.Same(first, levels.Terrain([0, 1]));
        NestedTerrain alone = levels.Terrain([0, null]);
        Assert.Equal(0, alone.Surface.Seams.Count);
        Assert.Equal(alone.Models[0].Projection.Resolution, alone.Resolution);
    }

    /// <summary>A hole of one sample is not seen in the means; a wide one stays a hole.</summary>
    [Fact]
    public void Terrain_GapsAtALevel_AreWhereNoSampleHasData()
    {
        NestedTerrain terrain = NestedScenes.Named("gaps at 02");
        ITerrainGrid level = terrain.Models[1];
        bool[] gaps = new bool[level.Samples];
        level.ReadGaps(10, 0, gaps); // lines 40 to 43: the hole around (40, 70) has a radius of 9.5, right of 104 there is nothing
        Assert.Equal([16, 17, 18, 27, 28, 29], Enumerable.Range(0, 30).Where(sample => gaps[sample]));
    }

    [Fact]
    public void AngleTo_AnyDirection_IsJustBelowTheNearestVertex()
    {
        NestedTerrain terrain = NestedScenes.Named("crossing");
        Random random = new(5);
        for (int number = 0; number < 40; number++)
        {
            Vector3D direction = new Vector3D(
                random.NextDouble() - 0.5, random.NextDouble() - 0.5, -0.2 - random.NextDouble()).Normalized();
            for (int part = 1; part < 3; part++)
            {
                ITerrainGrid grid = terrain.Models[part];
                double nearest = Enumerable.Range(0, grid.Lines * grid.Samples).Min(place => Vector3D.AngleBetween(
                    direction, grid.Projection.DirectionOf(place / grid.Samples, place % grid.Samples)));
                double block = 64.0 * terrain.WholeParts[part].Geometry.CellAngle;
                Assert.InRange(
                    ModelReach.AngleTo(terrain.WholeParts[part], direction), (0.94 * nearest) - block, nearest + Rounding.OfPlaces);
            }
        }
    }

    [Theory]
    [InlineData("five", 1, 2, true)]
    [InlineData("five", 1, 4, true)]
    [InlineData("five", 0, 3, true)]
    [InlineData("five", 2, 1, false)]
    [InlineData("crossing", 1, 2, false)]
    [InlineData("gaps", 0, 1, true)]
    public void Covers_ModelsOfAScene_AreAsTheyLie(string name, int coarser, int finer, bool covers) =>
        Assert.Equal(covers, NestedScenes.LevelsOf(name).Covers(coarser, finer));

    private static List<(Vector3D, Vector3D, Vector3D)> CornersOf(SeamPatch seams) =>
        [.. Enumerable.Range(0, seams.Count).Select(seams.CornersOf)];

    private static double[][] RadiiOf(GridPatch part) => [.. Enumerable.Range(0, part.Grid.Lines).Select(line =>
    {
        double[] radii = new double[part.Grid.Samples];
        part.Grid.ReadRadii(line, 0, radii);
        return radii;
    })];
}
