using Msisf.Adapters.Tiles;
using Msisf.Core.Errors;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Tiles;

public sealed class PatternRepositoryTests : IDisposable
{
    private static readonly TileId[] Tiles = [new(85, 0), new(-5, 355), new(-90, 10)];

    private readonly TemporaryFolder _folder = new();
    private readonly PatternRepository _repository;

    public PatternRepositoryTests() => _repository = new PatternRepository(_folder["patterns"]);

    public void Dispose()
    {
        _repository.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public void PathOf_NegativeLatitude_IsNamedAsInTheThesis() => Assert.Equal(
        Path.Combine(_folder["patterns"], "64", "pattern_LDEM_64_lat_-5_0_lon_355_360.inc"),
        _repository.PathOf(new TileId(-5, 355), 64));

    [Fact]
    public void EnsurePatterns_NewRepository_MakesEachTileOnceInOrder()
    {
        PatternSet set = Ensure([.. Tiles, Tiles[0]]);

        Assert.Equal(3, set.Written);
        Assert.Equal([PathOf(2), PathOf(1), PathOf(0)], set.Paths);
        Assert.All(set.Paths, path => Assert.True(File.Exists(path)));
        Assert.Equal(3, Directory.GetFiles(_repository.FolderOf(1), "pattern_*").Length);
    }

    [Fact]
    public void EnsurePatterns_Again_KeepsThem()
    {
        DateTime[] before = [.. Ensure(Tiles).Paths.Select(File.GetLastWriteTimeUtc)];

        PatternSet again = Ensure(Tiles);

        Assert.Equal(0, again.Written);
        Assert.Equal(before, again.Paths.Select(File.GetLastWriteTimeUtc));
    }

    [Fact]
    public void EnsurePatterns_OtherThreads_MakeTheSameBytes()
    {
        byte[][] first = [.. Ensure(Tiles).Paths.Select(File.ReadAllBytes)];
        PatternRepository other = new(_folder["other"]);

        PatternSet set = other.EnsurePatterns(Tiles.Reverse(), FunctionGrid.Rough(1), default, maxParallelism: 3);

        Assert.Equal(first, set.Paths.Select(File.ReadAllBytes));
    }

    [Theory]
    [InlineData("empty")]
    [InlineData("zeros")]
    [InlineData("cut in the mark")]
    [InlineData("cut in the header")]
    [InlineData("one byte short")]
    [InlineData("one byte long")]
    [InlineData("older format")]
    public void EnsurePatterns_DamagedFile_IsMadeAgain(string damage)
    {
        Ensure(Tiles);
        byte[] good = File.ReadAllBytes(PathOf(1));
        byte[] bad = damage switch
        {
            "empty" => [],
            "zeros" => new byte[good.Length],
            "cut in the mark" => good[..7],
            "cut in the header" => good[..100],
            "one byte short" => good[..^1],
            "one byte long" => [.. good, (byte)'\n'],
            _ => [.. "// msisf-pattern 0"u8, .. good[18..]],
        };
        File.WriteAllBytes(PathOf(1), bad);

        Assert.Equal(1, Ensure(Tiles).Written);
        Assert.Equal(good, File.ReadAllBytes(PathOf(1)));
    }

    [Fact]
    public void EnsurePatterns_ModelChangedInOneSample_MakesOnlyTheTilesThatUseIt()
    {
        FunctionGrid rough = FunctionGrid.Rough(1);
        TileId[] around = [.. TileId.All.Where(tile => tile.SouthDegrees is >= -15 and <= 10 && tile.WestDegrees <= 15)];
        _repository.EnsurePatterns(around, rough, default, maxParallelism: 2);

        // The north-west sample of a tile is the outer corner of three neighbours' cells too.
        FunctionGrid changed = new(1, (line, sample) => RadiusOf(rough, line, sample) + ((line, sample) == (90, 5) ? 0.5 : 0.0));

        Assert.Equal(4, _repository.EnsurePatterns(around, changed, default, maxParallelism: 2).Written);
    }

    [Theory]
    [InlineData(0.5, PatternFormat.Mesh2)]
    [InlineData(0.0, PatternFormat.Mesh)]
    public void EnsurePatterns_OtherOptions_AreMadeAgain(double margin, PatternFormat format)
    {
        Ensure(Tiles);

        Assert.Equal(
            3, _repository.EnsurePatterns(Tiles, FunctionGrid.Rough(1), new PatternOptions(margin, format), maxParallelism: 2).Written);
        Assert.Equal(3, Ensure(Tiles).Written);
    }

    [Theory]
    [InlineData("mesh {\ntriangle {\n<1,2,3>")]
    [InlineData("// my own pattern")]
    [InlineData("x")]
    public void EnsurePatterns_ForeignFile_IsLeftAloneAndNamed(string content)
    {
        Directory.CreateDirectory(_repository.FolderOf(1));
        File.WriteAllText(PathOf(1), content);

        BadInputException exception = Assert.Throws<BadInputException>(() => Ensure(Tiles));

        Assert.StartsWith(
            PathOf(1) + ": has a pattern's name, but this program has not made it", exception.Message, StringComparison.Ordinal);
        Assert.Equal(content, File.ReadAllText(PathOf(1)));
    }

    [Fact]
    public void EnsurePatterns_FolderUnderAPatternsName_IsNamed()
    {
        Directory.CreateDirectory(PathOf(1));

        Assert.StartsWith(PathOf(1), Assert.Throws<ExternalPartException>(() => Ensure(Tiles)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void EnsurePatterns_FolderThatCannotBeMade_IsNamed()
    {
        File.WriteAllText(_folder["patterns"], "a file where the repository should be");

        Assert.StartsWith(
            _repository.FolderOf(1) + ": can't be made",
            Assert.Throws<ExternalPartException>(() => Ensure(Tiles)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void EnsurePatterns_RepositoryThatCannotBeWritten_LeavesNoPartAndSaysSo()
    {
        // The kernel lets nobody, not even root, make files there; a folder without write permission would not stop root.
        PatternRepository readOnly = new("/proc/self/task");

        Assert.Contains(
            "/proc/self/task",
            Assert.Throws<ExternalPartException>(() => readOnly.EnsurePatterns(Tiles, FunctionGrid.Rough(1), default, 1)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void EnsurePatterns_LeftoversOfKilledRuns_GoAfterAnHour()
    {
        Ensure(Tiles[..1]);
        string old = Path.Combine(_repository.FolderOf(1), "pattern_LDEM_1_lat_0_5_lon_0_5.99-abc.partial.inc");
        string young = Path.Combine(_repository.FolderOf(1), "pattern_LDEM_1_lat_0_5_lon_0_5.98-abc.partial.inc");
        File.WriteAllText(old, "half");
        File.WriteAllText(young, "half");
        File.SetLastWriteTimeUtc(old, File.GetLastWriteTimeUtc(young).AddHours(-2));

        Ensure(Tiles);

        Assert.False(File.Exists(old));
        Assert.True(File.Exists(young));
    }

    [Fact]
    public async Task EnsurePatterns_SeveralWritersAtOnce_NeverShowAHalfFile()
    {
        TileId[] tiles = [.. TileId.All.Take(80)];
        byte[][] expected = [.. new PatternRepository(_folder["expected"]).EnsurePatterns(
            tiles, FunctionGrid.Rough(1), default, 2).Paths.Select(File.ReadAllBytes)];

        // No file can be locked under the name of a folder: these make the same files at the same time, as where the file system knows no
        // locks.
        Directory.CreateDirectory(Path.Combine(_repository.FolderOf(1), ".msisf-claims"));
        PatternSet[] sets = await Within.Seconds(120, "three writers at once", Task.WhenAll(Enumerable.Range(0, 3).Select(_ => Task.Run(
            () => new PatternRepository(_folder["patterns"]).EnsurePatterns(tiles, FunctionGrid.Rough(1), default, maxParallelism: 2)))));

        Assert.All(sets, set => Assert.Equal(expected, set.Paths.Select(File.ReadAllBytes)));
        Assert.Equal(80, Directory.GetFiles(_repository.FolderOf(1), "pattern_*").Length);
    }

    [Fact]
    public void EnsurePatterns_Cancelled_StopsWithoutLeftovers()
    {
        using CancellationTokenSource source = new();
        Progress progress = new(source.Cancel);

        Assert.Throws<OperationCanceledException>(
            () => _repository.EnsurePatterns(TileId.All, FunctionGrid.Rough(1), default, 1, progress, source.Token));

        string left = Assert.Single(Directory.GetFiles(_repository.FolderOf(1), "pattern_*"));
        Assert.Equal("pattern_LDEM_1_lat_-90_-85_lon_0_5.inc", Path.GetFileName(left));
    }

    [Fact]
    public void EnsurePatterns_DamagedModel_PassesTheModelsError()
    {
        FunctionGrid damaged = new(1, (_, _) => throw new BadInputException("line 3"));

        Assert.Equal("line 3", Assert.Throws<BadInputException>(() => _repository.EnsurePatterns(Tiles, damaged, default, 2)).Message);
        Assert.False(Directory.Exists(_repository.FolderOf(1)));
    }

    private static double RadiusOf(FunctionGrid grid, int line, int sample)
    {
        double[] radius = new double[1];
        grid.ReadRadii(line, sample, radius);
        return radius[0];
    }

    private PatternSet Ensure(TileId[] tiles) => _repository.EnsurePatterns(tiles, FunctionGrid.Rough(1), default, maxParallelism: 2);

    private string PathOf(int tile) => _repository.PathOf(Tiles[tile], 1);

    private sealed class Progress(Action report) : IProgress<int>
    {
        public void Report(int value) => report();
    }
}
