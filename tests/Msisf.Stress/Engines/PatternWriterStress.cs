using System.Globalization;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Tiles;
using Msisf.Core.Tiles;
using Msisf.TestSupport;

namespace Msisf.Stress.Engines;

/// <summary>The PHP pattern writer against the C# one, byte by byte.</summary>
/// <remarks>
/// The PHP writer is driven from an image. That its database gives the same samples is shown by php <c>SamePatternsTest</c>.
/// </remarks>
public sealed class PatternWriterStress : IStressTest
{
    private const int RandomPixelsPerDegree = 8;

    /// <summary>Tiles at poles and seam: each has a form of its own.</summary>
    private static readonly TileId[] Corners =
        [new(-90, 0), new(-90, 180), new(-90, 355), new(0, 0), new(0, 355), new(85, 0), new(85, 90), new(85, 355)];

    /// <inheritdoc/>
    public string Name => "pattern-writers";

    /// <inheritdoc/>
    public string Subject =>
        "The two pattern writers, PHP and C#: files compared byte by byte; "
            + "LDEM_4 (all its tiles at full length) and a model of random heights at 8 px/deg, both forms of the mesh, "
            + "margins of up to a degree.";

    /// <inheritdoc/>
    public string? MissingPart =>
        TestParts.Ldem4Label is null ? "LDEM_4 (msis fetch ldem)" : TestParts.Program("php") is null ? "PHP" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        bool isFull = length == StressLength.Full;
        using TemporaryFolder folder = new();
        using LdemImage real = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        string realImage = Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG");
        string randomImage = folder["RANDOM.IMG"];
        RandomImage.Write(randomImage, RandomPixelsPerDegree, seed);
        FunctionGrid random = RandomImage.Grid(RandomPixelsPerDegree, seed);
        CaseRandom draw = new(seed, part: 0);
        IReadOnlyList<TileId> Tiles(int everyday, int full) => SomeTiles(draw, isFull ? full : everyday);
        PatternJob[] jobs =
        [
            new(real, realImage, PatternFormat.Mesh2, 0, isFull ? [.. TileId.All] : Tiles(200, 0)),
            new(real, realImage, PatternFormat.Mesh2, 2, Tiles(20, 1000)),
            new(real, realImage, PatternFormat.Mesh, 2, Tiles(10, 500)),
            new(real, realImage, PatternFormat.Mesh, 0, isFull ? [.. TileId.All] : Tiles(10, 0)),
            new(random, randomImage, PatternFormat.Mesh2, 0, Tiles(4, 400)),
            new(random, randomImage, PatternFormat.Mesh2, RandomPixelsPerDegree, Tiles(2, 100)),
            new(random, randomImage, PatternFormat.Mesh, 1, Tiles(2, 100)),
        ];
        WorstCase worst = new();
        long files = 0;
        foreach ((int number, PatternJob job) in jobs.Index())
        {
            files += Compare(job, folder[number.ToString(CultureInfo.InvariantCulture)], worst);
        }

        return new StressReport(Name, files, [worst.ToFigure("bytes of a file that differ", "", 0.0)], []);
    }

    private static TileId[] SomeTiles(CaseRandom draw, int count)
    {
        TileId[] all = [.. TileId.All];
        return [.. Enumerable.Range(0, count).Select(_ => all[draw.Below(all.Length)]).Concat(Corners).Distinct().Order()];
    }

    private static int Compare(PatternJob job, string folder, WorstCase worst)
    {
        int resolution = job.Grid.PixelsPerDegree;
        WriteByPhp(job, folder);
        PatternRepository repository = new(folder);
        TileMeshBuilder builder = new(job.Grid);
        foreach (TileId tile in job.Tiles)
        {
            TileMeshLayout layout = TileMeshLayout.For(tile, resolution, job.MarginSamples);
            using MemoryStream expected = new();
            PatternWriter.Write(expected, builder.Build(layout, builder.ReadRadii(layout)), job.Grid.ProductId, job.Format);
            double differing = DifferingBytes(
                expected.GetBuffer().AsSpan(0, (int)expected.Length), File.ReadAllBytes(repository.PathOf(tile, resolution)));
            worst.Note(
                differing,
                () =>
                    $"{job.Grid.ProductId} at {resolution} px/deg, {tile.RangeText}, {job.Format}, margin of {job.MarginSamples} samples");
        }

        return job.Tiles.Count;
    }

    private static void WriteByPhp(PatternJob job, string folder)
    {
        string script = Path.Combine(TestParts.RepositoryRoot, "tests", "php", "support", "write_patterns.php");
        string tiles = string.Concat(job.Tiles.Select(tile => $"{tile.SouthDegrees} {tile.WestDegrees}\n"));
        string format = job.Format == PatternFormat.Mesh ? "mesh" : "mesh2";
        ChildRun.Of(
            TestParts.Program("php")!,
            [script, job.Image, job.Grid.ProductId, $"{job.Grid.PixelsPerDegree}", format, $"{job.MarginSamples}", folder],
            TestParts.RepositoryRoot,
            tiles).Succeeded();
    }

    /// <summary>Bytes that are not the same, with those that one file has more than the other.</summary>
    private static int DifferingBytes(ReadOnlySpan<byte> one, ReadOnlySpan<byte> other)
    {
        int common = Math.Min(one.Length, other.Length);
        int differing = Math.Max(one.Length, other.Length) - common;
        if (one[..common].SequenceEqual(other[..common]))
        {
            return differing;
        }

        for (int i = 0; i < common; i++)
        {
            differing += one[i] == other[i] ? 0 : 1;
        }

        return differing;
    }
}
