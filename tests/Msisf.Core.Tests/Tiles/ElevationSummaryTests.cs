using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public sealed class ElevationSummaryTests
{
    private static readonly MemoryElevationGrid Coarse = Noise(2);
    private static readonly MemoryElevationGrid Fine = Noise(16);

    [Theory]
    [InlineData(2)]
    [InlineData(16)]
    public void Build_EveryBlock_HasTheBoundsOfItsVertices(int pixelsPerDegree)
    {
        MemoryElevationGrid grid = pixelsPerDegree == 2 ? Coarse : Fine;
        ElevationSummary summary = ElevationSummary.Build(grid);
        int lines = 180 * pixelsPerDegree;
        foreach (SummaryLevel level in summary.Levels)
        {
            // A prime step: samples of all rows and columns, both borders included.
            for (int index = 0; index < level.Count; index += level.Count > 10_000 ? 61 : 1)
            {
                CellRange cells = level.Cells(index / level.Columns, index % level.Columns);
                int first = Math.Max(cells.FirstLine, 0);
                int last = Math.Min(cells.EndLine, lines - 1);
                (double min, double max) = grid.RadiusBounds(
                    first, last - first + 1, cells.FirstSample, cells.EndSample - cells.FirstSample + 1);
                NodeBounds bounds = level.BoundsOf(index / level.Columns, index % level.Columns);
                Assert.InRange(bounds.Min, min - 0.26, min);
                Assert.InRange(bounds.Max, max, max + 0.26);
            }
        }
    }

    [Fact]
    public void Build_EveryFacet_LiesWithinItsNode()
    {
        ElevationSummary summary = ElevationSummary.Build(Coarse);
        FacetMesh mesh = new(Coarse);
        TerrainPatch patch = new(mesh);
        SummaryLevel level = summary.Levels[^1];
        Random random = new(7);
        for (int index = 0; index < level.Count; index += 17)
        {
            TerrainNode node = level.Node(index / level.Columns, index % level.Columns);
            patch.Load(level.Cells(index / level.Columns, index % level.Columns));
            for (int line = 0; line + 1 < patch.Lines; line++)
            {
                for (int sample = 0; sample + 1 < patch.Samples; sample++)
                {
                    CheckFacet(node, patch[line, sample], patch[line + 1, sample], patch[line + 1, sample + 1], random);
                    CheckFacet(node, patch[line, sample], patch[line + 1, sample + 1], patch[line, sample + 1], random);
                }
            }
        }
    }

    [Fact]
    public void OnDemand_WrongCountOrValue_IsBadInput()
    {
        float[] values = ElevationSummary.Build(Coarse).ToValues();

        Assert.Throws<BadInputException>(() => ElevationSummary.OnDemand(Fine, values));
        values[4] = float.NaN;
        Assert.Throws<BadInputException>(() => ElevationSummary.OnDemand(Coarse, values));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(16)]
    public void OnDemand_Blocks_AreThoseOfTheWholeModel(int pixelsPerDegree)
    {
        MemoryElevationGrid grid = pixelsPerDegree == 2 ? Coarse : Fine;
        ElevationSummary whole = ElevationSummary.Build(grid);
        ElevationSummary onDemand = ElevationSummary.OnDemand(grid);
        onDemand.Read([TileId.FromNorth.First()]);
        for (int index = 0; index < whole.Levels[0].Count; index += 7)
        {
            (int row, int column) = int.DivRem(index, whole.Levels[0].Columns);
            Assert.Equal(whole.Levels[0].Node(row, column), onDemand.Levels[0].Node(row, column));
        }
    }

    [Fact]
    public void OnDemand_ValuesOfAPart_AreKnownAndTheRestIsNot()
    {
        ElevationSummary first = ElevationSummary.OnDemand(Coarse);
        TileId[] tiles = [.. TileId.FromNorth];
        first.Read([tiles[0], tiles[1000]]);
        ElevationSummary second = ElevationSummary.OnDemand(Coarse, first.ToValues());

        second.Read([tiles[1000]]);
        Assert.Equal(0, second.SamplesRead);
        Assert.Equal(first.ToValues(), second.ToValues());
        second.Read([tiles[1001]]);
        Assert.Equal(100, second.SamplesRead); // 5 x 5 degrees at 2 px/deg
    }

    /// <summary>What a node may be is decided before it is read: its unread bounds have to contain those that it gets.</summary>
    [Fact]
    public void NodeUnread_AnyNode_ContainsTheNodeThatIsRead()
    {
        ElevationSummary summary = ElevationSummary.OnDemand(Coarse);
        foreach (TileId tile in TileId.All)
        {
            TerrainNode unread = summary.Levels[0].NodeUnread(tile);
            TerrainNode read = summary.Levels[0].NodeOf(tile);

            Assert.True(unread.IsUnread && !read.IsUnread && !summary.Levels[0].NodeUnread(tile).IsUnread);
            Assert.True(unread.MinRadius <= read.MinRadius && unread.MaxRadius >= read.MaxRadius);
            Assert.True((unread.Ball().Centre - read.Ball().Centre).Length + read.Ball().Radius <= unread.Ball().Radius);
        }
    }

    private static void CheckFacet(in TerrainNode node, Vector3D a, Vector3D b, Vector3D c, Random random)
    {
        double u = random.NextDouble();
        double v = random.NextDouble() * (1.0 - u);
        Vector3D point = a + (u * (b - a)) + (v * (c - a));
        Assert.InRange(point.Length, node.MinRadius, node.MaxRadius);
        Assert.True(Vector3D.Dot(point.Normalized(), node.Cap.Centre) >= node.Cap.CosRadius);

        Vector3D normal = Vector3D.Cross(b - a, c - a);
        if (normal.Length > 1e-3)
        {
            double slope = Vector3D.AngleBetween(normal, point);
            Assert.True(Math.Tan(slope) <= node.MaxSlope, $"{Math.Tan(slope)} > {node.MaxSlope}");
        }
    }

    private static MemoryElevationGrid Noise(int pixelsPerDegree)
    {
        Random random = new(20120222);
        return new MemoryElevationGrid("NOISE", pixelsPerDegree, (_, _) => 1_737_400.0 + random.Next(-9000, 9000));
    }
}
