using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class PyramidFileTests : IDisposable, IClassFixture<PyramidFileTests.Model>
{
    private const int Resolution = 8;

    private readonly TemporaryFolder _folder = new();
    private readonly string _label;

    public PyramidFileTests(Model model)
    {
        foreach (string path in Directory.GetFiles(model.Folder.Path))
        {
            File.Copy(path, _folder[Path.GetFileName(path)]);
        }

        _label = _folder[Path.GetFileName(model.Label)];
    }

    private string Sidecar => Path.ChangeExtension(_label, ".pyramid");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Levels_Stored_HaveTheBitsOfComputedOnes()
    {
        using LdemImage image = Open();
        Make(image);
        LodLevels computed = LodLevels.Open(image);
        using ModelLevels stored = ModelLevels.Open(image, null);

        Assert.Equal(Sidecar, stored.Sidecar?.FilePath);
        Assert.Null(stored.Warning);
        Assert.Equal([2, 1], stored.Sidecar!.Levels.Select(level => ((IGlobalGrid)level).PixelsPerDegree));
        for (int level = 1; level < computed.Count; level++)
        {
            Assert.Equal(Everything(computed.Level(level)), Everything(stored.Levels.Level(level)));
        }

        Assert.Equal(computed.Level(3).RadiusBounds(0, 180, 0, 360), stored.Levels.Level(3).RadiusBounds(0, 180, 0, 360));
    }

    [Fact]
    public void Levels_OddNumberOfBlockRows_HaveTheLastOne()
    {
        // At 24 px/deg the first stored level has 17 rows of blocks; the last one alone makes the last row of the next level.
        string text = TestModel.Label
            .Replace("= 180\n", "= 4320\n", StringComparison.Ordinal)
            .Replace("= 360\n", "= 8640\n", StringComparison.Ordinal)
            .Replace("= 720\n", "= 17280\n", StringComparison.Ordinal)
            .Replace("= 1 <pix/deg>", "= 24 <pix/deg>", StringComparison.Ordinal)
            .Replace("= 89.5", "= 2159.5", StringComparison.Ordinal)
            .Replace("= 179.5", "= 4319.5", StringComparison.Ordinal);
        byte[] samples = new byte[4320 * 8640 * sizeof(short)];
        samples.AsSpan(4300 * 8640 * sizeof(short)).Fill(0x11); // 4369 units of 0.5 m
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(TestModel.Write(_folder.Path, text, samples)));
        PyramidWriter.Write(image, _folder["odd"], 2, null, CancellationToken.None);
        using PyramidFile file = PyramidFile.TryOpen(_folder["odd"], image, out _)!;
        double[] radii = new double[1080];
        file.Levels[1].ReadRadii(539, 0, radii);

        Assert.All(radii, radius => Assert.Equal(1737400.0 + 2184.5, radius));
    }

    [Fact]
    public void Write_AnyNumberOfThreads_GivesTheSameBytes()
    {
        using LdemImage image = Open();
        PyramidWriter.Write(image, _folder["one"], threads: 1, null, CancellationToken.None);
        PyramidWriter.Write(image, _folder["four"], threads: 4, null, CancellationToken.None);

        Assert.Equal(File.ReadAllBytes(_folder["one"]), File.ReadAllBytes(_folder["four"]));
    }

    [Fact]
    public void TryOpen_NoFile_IsNoProblem()
    {
        using LdemImage image = Open();

        Assert.Null(PyramidFile.TryOpen(Sidecar, image, out string? problem));
        Assert.Null(problem);
    }

    [Theory]
    [InlineData(3, "it is damaged, or no pyramid")]
    [InlineData(20, "it is damaged, or no pyramid")]
    [InlineData(130, "it is damaged, or no pyramid")]
    [InlineData(4096, "it is damaged")]
    public void Open_DamagedHead_WarnsAndComputes(int position, string problem)
    {
        using LdemImage image = Open();
        Make(image);
        Damage(position);
        using ModelLevels levels = ModelLevels.Open(image, null);

        Assert.Null(levels.Sidecar);
        Assert.Contains($"{Sidecar}: {problem}", levels.Warning, StringComparison.Ordinal);
        Assert.IsType<ReducedMoon>(levels.Levels.Level(2));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(1)]
    [InlineData(-1_000_000)]
    public void Open_AnotherLength_WarnsAndComputes(int change)
    {
        using LdemImage image = Open();
        Make(image);
        using (FileStream stream = new(Sidecar, FileMode.Open))
        {
            stream.SetLength(stream.Length + change);
        }

        using ModelLevels levels = ModelLevels.Open(image, null);

        Assert.Null(levels.Sidecar);
        // A page, a page for 90 check sums, 6 x 12 and 3 x 6 blocks of 16384 bytes.
        Assert.Contains("bytes, 1482752 expected", levels.Warning, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_ModelChangedSince_WarnsAndComputes()
    {
        using LdemImage image = Open();
        Make(image);
        File.SetLastWriteTimeUtc(Path.ChangeExtension(_label, ".IMG"), new DateTime(2017, 9, 15, 0, 0, 0, DateTimeKind.Utc));
        using ModelLevels levels = ModelLevels.Open(image, null);

        Assert.Null(levels.Sidecar);
        Assert.Contains("it is of another model, or LDEM_8_SYNTHETIC was changed", levels.Warning, StringComparison.Ordinal);
    }

    [Fact]
    public void ReadRadii_DamagedBlock_IsNeverHandedOut()
    {
        using LdemImage image = Open();
        Make(image);
        Damage((int)PyramidLayout.OfMoon(Resolution).OffsetOf(13) + 5000);
        using ModelLevels levels = ModelLevels.Open(image, null);
        double[] radii = new double[2];

        levels.Levels.Level(2).ReadRadii(64, 0, radii); // block 12
        string message = Assert.Throws<BadInputException>(() => levels.Levels.Level(2).ReadRadii(64, 127, radii)).Message;

        Assert.Contains("block 13 of the level of 2 px/deg is damaged", message, StringComparison.Ordinal);
        Assert.Throws<BadInputException>(() => levels.Sidecar!.Verify(image, CancellationToken.None));
    }

    [Fact]
    public void Verify_SamplesChangedUnderTheSameTime_SaysSo()
    {
        string imagePath = Path.ChangeExtension(_label, ".IMG");
        DateTime written = File.GetLastWriteTimeUtc(imagePath);
        using (LdemImage image = Open())
        {
            Make(image);
            using PyramidFile file = PyramidFile.TryOpen(Sidecar, image, out _)!;
            file.Verify(image, CancellationToken.None);
        }

        byte[] bytes = File.ReadAllBytes(imagePath);
        (bytes[0], bytes[5000]) = (bytes[5000], bytes[0]);
        File.WriteAllBytes(imagePath, bytes);
        File.SetLastWriteTimeUtc(imagePath, written);
        using LdemImage changed = Open();
        using PyramidFile foreign = PyramidFile.TryOpen(Sidecar, changed, out _)!;

        Assert.Contains(
            "made of other samples",
            Assert.Throws<BadInputException>(() => foreign.Verify(changed, CancellationToken.None)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Write_Cancelled_LeavesTheOldFileOnly()
    {
        using LdemImage image = Open();
        Make(image);
        byte[] before = File.ReadAllBytes(Sidecar);
        using CancellationTokenSource source = new();
        CancelAtOnce progress = new(source);

        Assert.ThrowsAny<OperationCanceledException>(() => PyramidWriter.Write(image, Sidecar, 2, progress, source.Token));

        Assert.Equal(before, File.ReadAllBytes(Sidecar));
        Assert.Equal(3, Directory.GetFiles(_folder.Path).Length);
    }

    [Fact]
    public void Write_DamagedSample_NamesItAndLeavesNothing()
    {
        byte[] bytes = File.ReadAllBytes(Path.ChangeExtension(_label, ".IMG"));
        bytes.AsSpan(2 * ((1000 * 2880) + 7), 2).Fill(0x7f);
        File.WriteAllBytes(Path.ChangeExtension(_label, ".IMG"), bytes);
        using LdemImage image = Open();

        Assert.Contains(
            "line 1001, sample 8: the value 32639", Assert.Throws<BadInputException>(() => Make(image)).Message, StringComparison.Ordinal);
        Assert.Equal(2, Directory.GetFiles(_folder.Path).Length);
    }

    [Fact]
    public void Write_CoarseModel_SaysThatItNeedsNone()
    {
        string label = TestModel.Write(_folder.Path, TestModel.Label, TestModel.IntegerImage(bigEndian: false));
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(label));

        Assert.Contains("1 px/deg has no levels", Assert.Throws<BadInputException>(() => Make(image)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Places_FolderThatTakesNoFiles_IsTheCache()
    {
        LdemSet set = LdemCatalog.Read(_label);
        LdemSet elsewhere = LdemSet.Join([set.Parts[0] with { ImagePath = "/nowhere/at all/LDEM_8.IMG" }]);

        Assert.Equal(Sidecar, ModelLevels.PlacesOf(set, _folder["cache"]).ForWriting());
        Assert.StartsWith(
            _folder["cache"] + "/LDEM_8_SYNTHETIC-",
            ModelLevels.PlacesOf(elsewhere, _folder["cache"]).ForWriting(),
            StringComparison.Ordinal);
        Assert.Equal("/nowhere/at all/LDEM_8.pyramid", ModelLevels.PlacesOf(elsewhere, null).ForWriting());
    }

    [Fact]
    public void Open_SidecarInTheCache_IsUsed()
    {
        using LdemImage image = Open();
        string cached = ModelLevels.PlacesOf(image.Set, _folder["cache"]).Cached!;
        Directory.CreateDirectory(_folder["cache"]);
        PyramidWriter.Write(image, cached, 2, null, CancellationToken.None);
        File.WriteAllText(Sidecar, "not a pyramid");
        using ModelLevels levels = ModelLevels.Open(image, _folder["cache"]);

        Assert.Equal(cached, levels.Sidecar?.FilePath);
        Assert.Null(levels.Warning);
    }

    private static double[] Everything(IGlobalGrid grid)
    {
        int samples = 360 * grid.PixelsPerDegree;
        double[] radii = new double[180 * grid.PixelsPerDegree * samples];
        for (int line = 0; line < 180 * grid.PixelsPerDegree; line++)
        {
            grid.ReadRadii(line, 0, radii.AsSpan(line * samples, samples));
        }

        return radii;
    }

    private LdemImage Open() => LdemImage.Open(LdemCatalog.Read(_label));

    private void Make(LdemImage image) => PyramidWriter.Write(image, Sidecar, 2, null, CancellationToken.None);

    private void Damage(int position)
    {
        byte[] bytes = File.ReadAllBytes(Sidecar);
        bytes[position] ^= 1;
        File.WriteAllBytes(Sidecar, bytes);
    }

    /// <summary>Making it takes longer than all that is done with it.</summary>
    public sealed class Model : IDisposable
    {
        public Model() =>
            Label = SyntheticLdemWriter.Write(new SyntheticLdemOptions(Resolution, Seed: 1, Folder.Path), null, CancellationToken.None);

        internal TemporaryFolder Folder { get; } = new();

        internal string Label { get; }

        public void Dispose() => Folder.Dispose();
    }

    private sealed class CancelAtOnce(CancellationTokenSource source) : IProgress<double>
    {
        public void Report(double value) => source.Cancel();
    }
}
