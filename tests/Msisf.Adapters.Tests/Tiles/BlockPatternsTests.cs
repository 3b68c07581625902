using Msisf.Adapters.Tiles;
using Msisf.Core.Blocks;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Tiles;

public sealed class BlockPatternsTests : IDisposable
{
    private static readonly SceneBlock First = new(0, 0, 0);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Ensure_MapAlone_WritesFacetsThatAreMetFromOutside()
    {
        // Cells of 3 m: steps of 2^-10 m, so a unit of 1.024 km has 2^20.
        ITerrainGrid map = PolarFunctionGrid.Rugged(isSouth: true, 3.0, 40, 19.5, 19.5);

        string text = File.ReadAllText(Write(map, First));

        Assert.StartsWith(
            "// msisf-pattern 2 format=mesh2 product=TEST_MAP model=0 block=0_0 sides=outside meshes=1 facets-sha256=", text,
            StringComparison.Ordinal);
        Assert.Contains("vertices=1089 faces=2048 bytes=", text, StringComparison.Ordinal); // 33 x 33, 32 x 32 x 2
        Assert.Contains("\n#local k=1/1048576;\nmesh2{\nvertex_vectors{1089,\n<", text, StringComparison.Ordinal);
        Assert.EndsWith(
            "scale 1.024\ntranslate -Origin\nscale UnitsPerKilometre\ntexture{moon}\ninterior_texture{pigment{rgbt 1}}\n}\n", text,
            StringComparison.Ordinal);
        Assert.Equal(new FileInfo(Path.Combine(_folder.Path, "TEST_MAP", "pattern_0_TEST_MAP_block_0_0.inc")).Length, text.Length);
    }

    [Fact]
    public void Ensure_SeveralModels_WritesFacetsThatAreMetFromBothSides()
    {
        NestedTerrain nested = new([FunctionGrid.Rugged(1), PolarFunctionGrid.Rugged(isSouth: true, 6000.0, 90, 44.5, 44.5)]);

        string text = File.ReadAllText(Write(nested, First));

        Assert.Contains(" sides=both ", text, StringComparison.Ordinal);
        Assert.Contains("\n#local k=1/131072;\n", text, StringComparison.Ordinal);
        Assert.EndsWith("texture{moon}\n}\n", text, StringComparison.Ordinal);
        Assert.EndsWith("pattern_2_seams_3.inc", Write(nested, new SceneBlock(2, 0, 3)), StringComparison.Ordinal);
    }

    [Fact]
    public void Ensure_Again_MakesOnlyWhatIsMissingOrOfOtherSamples()
    {
        ITerrainGrid map = PolarFunctionGrid.Rugged(isSouth: true, 300.0, 40, 19.5, 19.5);
        using PatternRepository repository = new(_folder.Path);
        SceneBlocks blocks = new(map);
        BlockPatterns patterns = new(repository, blocks, map);
        SceneBlock[] both = [First, new(0, 1, 0)];
        Assert.Equal(2, patterns.Ensure(both, 2, default).Written);
        Assert.Equal(0, patterns.Ensure(both, 2, default).Written);

        ITerrainGrid other = new HigherMap(map);
        Assert.Equal(2, new BlockPatterns(repository, new SceneBlocks(other), other).Ensure(both, 2, default).Written);
    }

    /// <summary>The same block at other levels, of its model or of one around it, is another file of the same folder.</summary>
    [Fact]
    public void FileNameOf_Levels_TellsThemApart()
    {
        NestedTerrain nested = new([FunctionGrid.Rugged(1), PolarFunctionGrid.Rugged(isSouth: true, 6000.0, 90, 44.5, 44.5)]);
        using PatternRepository repository = new(_folder.Path);
        SceneBlocks blocks = new(nested);
        string[] Names(string levels)
        {
            BlockPatterns patterns = new(repository, blocks, nested, levels);
            Assert.Equal(repository.FolderOf(BlockPatterns.FolderNameOf(nested)), patterns.Folder);
            return [patterns.FileNameOf(new SceneBlock(1, 2, 3)), patterns.FileNameOf(new SceneBlock(2, 0, 5))];
        }

        Assert.Equal(["pattern_1_TEST_MAP_block_2_3.inc", "pattern_2_seams_5.inc"], Names(string.Empty));
        Assert.Equal(["pattern_1_TEST_MAP_levels_0-x_block_2_3.inc", "pattern_2_levels_0-x_seams_5.inc"], Names("0-x"));
        string many = string.Join('-', Enumerable.Repeat("1", 100));
        Assert.All(Names(many), name => Assert.InRange(name.Length, 40, 100));
        Assert.NotEqual(Names(many), Names(many + "-2"));
    }

    [Theory]
    [InlineData("LDEM_80S_20M", "LDEM_80S_20M")]
    [InlineData("LDEM_4+LDEM_80S_20M", "LDEM_4_and_LDEM_80S_20M")]
    [InlineData("../a b\"ü.tif", "_._a_b__.tif")]
    public void NameOf_AnyModels_IsTheNameOfAFile(string productId, string expected) =>
        Assert.Equal(expected, BlockPatterns.NameOf(productId));

    [Fact]
    public void NameOf_ManyModels_IsShortAndTellsThemApart()
    {
        string many = string.Join('+', Enumerable.Range(0, 30).Select(number => $"LDEM_875S_{number}M"));
        Assert.Equal(120, BlockPatterns.NameOf(many).Length);
        Assert.NotEqual(BlockPatterns.NameOf(many), BlockPatterns.NameOf(many + "+X"));
    }

    private string Write(ITerrain terrain, SceneBlock block)
    {
        using PatternRepository repository = new(_folder.Path);
        BlockPatterns patterns = new(repository, new SceneBlocks(terrain), terrain);
        Assert.Equal(1, patterns.Ensure([block], 1, default).Written);
        return Path.Combine(patterns.Folder, patterns.FileNameOf(block));
    }

    /// <summary>The same map, a metre higher.</summary>
    private sealed class HigherMap(ITerrainGrid map) : ITerrainGrid
    {
        public string ProductId => map.ProductId;

        public MapProjection Projection => map.Projection;

        public int Lines => map.Lines;

        public int Samples => map.Samples;

        public (double Min, double Max) RadiusLimits => (map.RadiusLimits.Min, map.RadiusLimits.Max + 1.0);

        public void ReadRadii(int line, int firstSample, Span<double> radii)
        {
            map.ReadRadii(line, firstSample, radii);
            for (int i = 0; i < radii.Length; i++)
            {
                radii[i] += 1.0;
            }
        }
    }
}
