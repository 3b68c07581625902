using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>What is found by looking at all pixels once is what the samples say, and is kept for a large raster.</summary>
public sealed class RasterScanTests(LargeRaster large) : IDisposable, IClassFixture<LargeRaster>
{
    /// <summary>The same pixels at 4,096 px/deg, where no block of the grid begins.</summary>
    private const string Cylindrical = LargeRaster.Script
        + "; s = '+proj=longlat +R=1737400'; t = [30 + 77 / 4096, 1 / 4096, 0, 20 - 301 / 4096, 0, -1 / 4096]";

    private readonly TemporaryFolder _folder = new();
    private int _displays;

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Prepare_LargeRaster_IsKeptAndTrue()
    {
        string path = large.CopyTo(_folder);
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(grid.Prepare(cacheFolder: null, Display));
        Assert.True(File.Exists(_folder["site.scan"]));
        Random random = new(1);
        for (int i = 0; i < TestLength.Of(60, 5000); i++)
        {
            (int lines, int samples) = (random.Next(2, 400), random.Next(2, 600));
            (int line, int sample) = i == 0 ? (0, 4000) : (random.Next(0, 3700 - lines), random.Next(0, 4600 - samples));
            AssertBounds(grid, line, lines, sample, samples);
        }

        AssertLevels(grid);
        using GeoTiffGrid again = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(again.Prepare(cacheFolder: null, Display));
        Assert.Equal(1, _displays);
        AssertLevels(again);
        Assert.Equal(grid.BoundsOf(0, 3700, 0, 4600), again.BoundsOf(0, 3700, 0, 4600));

        File.SetLastWriteTimeUtc(path, DateTime.UtcNow.AddSeconds(-100));
        using GeoTiffGrid changed = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(changed.Prepare(cacheFolder: null, Display));
        Assert.Equal(2, _displays);
        using GeoTiffGrid moved = GeoTiffGrid.Open(path, libraryPath: null, new HeightOptions(Scale: null, Offset: 10.0));
        Assert.Null(moved.Prepare(cacheFolder: null, Display));
        Assert.Equal(3, _displays);
        Assert.Equal(10.0, moved.BoundsOf(0, 99, 0, 99)!.Value.Min - changed.BoundsOf(0, 99, 0, 99)!.Value.Min);
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Prepare_LargeCylindricalRaster_HasBoundsAndLevelsOfItsSamples()
    {
        using GeoTiffGrid grid = GeoTiffGrid.Open(TestRaster.Write(_folder, "site.tif", Cylindrical), libraryPath: null);
        Assert.Null(grid.WarpedFrom);
        Assert.Null(grid.Prepare(cacheFolder: null, Display));
        (int line, int sample) = (grid.Window.FirstLine, grid.Window.FirstSample);
        Assert.Equal((45, 77), (line % 256, sample % 256));
        AssertBounds(grid, line, 300, sample + 4000, 200);
        AssertBounds(grid, line + 990, 3, sample, 4600);
        AssertLevels(grid);
    }

    /// <summary>A run that is ended while it looks leaves nothing, and the next one looks from the beginning.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Prepare_Cancelled_LeavesNoFile()
    {
        string path = large.CopyTo(_folder);
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        using CancellationTokenSource end = new();
        Assert.ThrowsAny<OperationCanceledException>(() => grid.Prepare(
            cacheFolder: null, () => new FractionDisplay(new EndAtOnce(end), new MemoryStream()), end.Token));
        Assert.Equal([path], Directory.GetFiles(_folder.Path));
        Assert.Null(grid.Prepare(cacheFolder: null, Display));
        Assert.Equal(_folder["site.scan"], grid.FindKept(cacheFolder: null));
    }

    /// <summary>Levels that are missing are made again; those that say something else are found when all is looked at again.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Prepare_FileOfLevels_IsNeededAndVerified()
    {
        string path = large.CopyTo(_folder);
        string levels = _folder["site.pyramid"];
        using (GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null))
        {
            grid.Prepare(cacheFolder: null, Display);
            Assert.Equal(_folder["site.scan"], grid.VerifyKept(cacheFolder: null, CancellationToken.None));
        }

        byte[] bytes = File.ReadAllBytes(levels);
        File.Delete(levels);
        using (GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null))
        {
            Assert.Null(grid.FindKept(cacheFolder: null));
            Assert.Null(grid.Prepare(cacheFolder: null, Display));
            Assert.Equal(2, _displays);
        }

        Assert.Equal(bytes, File.ReadAllBytes(levels));
        bytes[^9] ^= 1;
        File.WriteAllBytes(levels, bytes);
        using GeoTiffGrid damaged = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(damaged.Prepare(cacheFolder: null, Display));
        Assert.Equal(2, _displays);
        string message = Assert.Throws<BadInputException>(() => damaged.VerifyKept(cacheFolder: null, CancellationToken.None)).Message;
        Assert.StartsWith($"{levels}: block ", message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(120_000, 1_500_000_000, 3, 1_210_114_048)]
    [InlineData(30_000, 1_500_000_000, 2, 305_086_464)]
    public void OfMap_SizeOfMap_DecidesTheFinestLevelThatIsKept(int side, long most, int firstLevel, long bytes)
    {
        PyramidLayout layout = PyramidLayout.OfMap(
            new WindowGrid(new PolarStereographic(true, 1.0, 0.5 * side, 0.5 * side), side), most);
        Assert.Equal((firstLevel, bytes), (layout.FirstLevel, layout.FileBytes));
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Prepare_FileOfScanThatIsDamaged_IsMadeAgain()
    {
        string path = large.CopyTo(_folder);
        using (GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null))
        {
            grid.Prepare(cacheFolder: null, Display);
        }

        byte[] bytes = File.ReadAllBytes(_folder["site.scan"]);
        bytes[^7] ^= 1;
        File.WriteAllBytes(_folder["site.scan"], bytes);
        using GeoTiffGrid again = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(again.Prepare(cacheFolder: null, Display));
        Assert.Equal(2, _displays);
    }

    /// <summary>
    /// The border, and the pixels up to which its slope is taken, are those of the file; of a kept scan they need no block of it.
    /// </summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void ReadRadii_BorderOfKeptScan_NeedsNoBlockOfTheFile()
    {
        string path = large.CopyTo(_folder);
        (int Line, int Sample, int Count)[] runs =
        [
            (0, 0, 4600), (64, 0, 4600), (3635, 0, 4600), (3699, 0, 4599),
            (3000, 0, 1), (3000, 64, 1), (3000, 4535, 1), (3000, 4599, 1), (3698, 0, 1), (3698, 4535, 1),
        ];
        using GeoTiffGrid file = GeoTiffGrid.Open(path, libraryPath: null);
        double[][] expected = [.. runs.Select(run => RadiiOf(file, run))]; // before it is scanned
        using (GeoTiffGrid scanned = GeoTiffGrid.Open(path, libraryPath: null))
        {
            Assert.Null(scanned.Prepare(cacheFolder: null, Display));
        }

        using GeoTiffGrid kept = GeoTiffGrid.Open(path, libraryPath: null); // looks at some blocks to guess what the values are
        Assert.Null(kept.Prepare(cacheFolder: null, Display));
        byte[] bytes = File.ReadAllBytes(path);
        bytes.AsSpan(bytes.Length / 2).Clear(); // blocks of the lower half can't be unpacked
        File.WriteAllBytes(path, bytes);
        Assert.Equal(1, _displays);
        Assert.Equal(expected, runs.Select(run => RadiiOf(kept, run)));
        bool[] isGap = new bool[2];
        kept.ReadGaps(3699, 4598, isGap);
        Assert.Equal([false, true], isGap);
        Assert.Throws<BadInputException>(() => Array.ForEach([2000, 2300, 2600, 2900, 3200], line => RadiiOf(kept, (line, 0, 4600))));
    }

    private static double[] RadiiOf(GeoTiffGrid grid, (int Line, int Sample, int Count) run)
    {
        double[] radii = new double[run.Count];
        grid.ReadRadii(run.Line, run.Sample, radii);
        return radii;
    }

    private FractionDisplay Display()
    {
        _displays++;
        return new FractionDisplay(new Progress<double>(), new MemoryStream());
    }

    private static void AssertBounds(GeoTiffGrid grid, int firstLine, int lines, int firstSample, int samples)
    {
        KnownBounds known = grid.BoundsOf(firstLine, lines, firstSample, samples)!.Value;
        bool mayHaveGaps = grid.MayHaveGapsIn(firstLine, lines, firstSample, samples);
        double[] above = new double[samples];
        double[] radii = new double[samples];
        bool[] gaps = new bool[samples];
        Array.Fill(above, double.NaN);
        for (int line = firstLine; line < firstLine + lines; line++)
        {
            grid.ReadGaps(line, firstSample, gaps);
            for (int i = 0; i < samples; i++)
            {
                Assert.True(mayHaveGaps || !gaps[i]);
                radii[i] = double.NaN;
                if (!gaps[i])
                {
                    grid.ReadRadii(line, firstSample + i, radii.AsSpan(i, 1));
                }

                // A comparison with NaN is false.
                bool isOutside = radii[i] < known.Min || radii[i] > known.Max || Math.Abs(radii[i] - above[i]) > known.Step + 1e-3
                    || (i > 0 && Math.Abs(radii[i] - radii[i - 1]) > known.Step + 1e-3);
                Assert.False(isOutside, $"{known}: line {line}, sample {firstSample + i}: {radii[i]}");
            }

            radii.CopyTo(above, 0);
        }
    }

    /// <summary>Levels from the stored one have the bits of those that are computed from the samples.</summary>
    private static void AssertLevels(GeoTiffGrid grid)
    {
        MapLevels stored = MapLevels.Open(grid, keepsGaps: true);
        Assert.Equal(stored.Count - 2, grid.StoredLevels.Count);
        Assert.All(Enumerable.Range(2, stored.Count - 2), level => Assert.Same(grid.StoredLevels[level - 2], stored.Grid(level)));
        MapLevels computed = MapLevels.Open(new Hidden(grid), keepsGaps: true);
        Assert.Equal(computed.Count, stored.Count);
        for (int level = 1; level < stored.Count; level++)
        {
            (ITerrainGrid one, ITerrainGrid other) = (stored.Grid(level), computed.Grid(level));
            Assert.Equal(other.Window, one.Window);
            bool[] gaps = new bool[one.Window.Samples];
            bool[] otherGaps = new bool[gaps.Length];
            double[] radii = new double[1];
            double[] otherRadii = new double[1];
            for (int line = one.Window.FirstLine; line < one.Window.EndLine; line += 13)
            {
                int first = one.Window.FirstSample;
                one.ReadGaps(line, first, gaps);
                other.ReadGaps(line, first, otherGaps);
                Assert.Equal(otherGaps, gaps);
                for (int i = line % 7; i < gaps.Length; i += 7)
                {
                    if (!gaps[i])
                    {
                        one.ReadRadii(line, first + i, radii);
                        other.ReadRadii(line, first + i, otherRadii);
                        Assert.Equal(otherRadii[0], radii[0]);
                    }
                }
            }
        }
    }

    /// <summary>Ends a work when it first says how far it has come.</summary>
    private sealed class EndAtOnce(CancellationTokenSource end) : IProgress<double>
    {
        public void Report(double value) => end.Cancel();
    }

    /// <summary>A map without samples.</summary>
    private sealed class WindowGrid(MapProjection projection, int side) : ITerrainGrid
    {
        public string ProductId => "empty";

        public MapProjection Projection => projection;

        public int Lines => side;

        public int Samples => side;

        public void ReadRadii(int line, int firstSample, Span<double> radii) => throw new NotSupportedException();
    }

    /// <summary>The same map without what it knows of itself.</summary>
    private sealed class Hidden(ITerrainGrid grid) : ITerrainGrid
    {
        public string ProductId => grid.ProductId;

        public MapProjection Projection => grid.Projection;

        public int Lines => grid.Lines;

        public int Samples => grid.Samples;

        public GridWindow Window => grid.Window;

        public bool MayHaveGaps => grid.MayHaveGaps;

        public void ReadGaps(int line, int firstSample, Span<bool> isGap) => grid.ReadGaps(line, firstSample, isGap);

        public void ReadRadii(int line, int firstSample, Span<double> radii) => grid.ReadRadii(line, firstSample, radii);
    }
}
