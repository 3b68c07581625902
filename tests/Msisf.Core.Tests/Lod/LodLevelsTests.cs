using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Lod;

public sealed class LodLevelsTests
{
    [Theory]
    [InlineData(512, 10)]
    [InlineData(64, 7)]
    [InlineData(12, 3)]
    [InlineData(1, 1)]
    public void Open_AnyResolution_HalvesItWhileItIsWhole(int resolution, int count)
    {
        LodLevels levels = LodLevels.Open(FunctionGrid.Rough(resolution));

        Assert.Equal(count, levels.Count);
        Assert.All(Enumerable.Range(0, count), level => Assert.Equal(resolution >> level, levels.Level(level).PixelsPerDegree));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void ReadRadii_HalfMetreSteps_AreTheExactMeans(int level)
    {
        FunctionGrid source = FunctionGrid.Rough(8); // heights are multiples of 0.5 m
        IGlobalGrid coarse = LodLevels.Open(source).Level(level);
        int factor = 1 << level;
        int samples = 360 * coarse.PixelsPerDegree;
        double[] radii = new double[samples];
        double[] fine = new double[factor];
        foreach (int line in new[] { 0, 63, 64, 90, (180 * coarse.PixelsPerDegree) - 1 })
        {
            int first = samples - 21;
            coarse.ReadRadii(line, first, radii);
            for (int i = 0; i < samples; i += 7)
            {
                long halfMetres = 0;
                for (int row = 0; row < factor; row++)
                {
                    source.ReadRadii((line * factor) + row, (first + i) % samples * factor, fine);
                    halfMetres += fine.Sum(radius => (long)(2.0 * radius));
                }

                Assert.Equal(halfMetres / (2.0 * factor * factor), radii[i]);
            }
        }
    }

    /// <summary>A block is 64 x 64 samples of the level; deep ones are fetched in several pieces.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void ReadRadii_OneBlock_FetchesExactlyWhatItReads(int level)
    {
        FetchedGrid grid = new(FunctionGrid.Hilly(16));

        LodLevels.Open(grid).Level(level).ReadRadii(70, 130, new double[1]);

        int edge = LodLayout.Side << level;
        Assert.Equal((edge * edge, 0, 0), (grid.Read, grid.ReadUnfetched, grid.FetchedInVain));
    }

    [Fact]
    public void ReadRadii_DeepestLevel_IsWithinTheStatedRounding()
    {
        const double Bound = 4 / 2048.0; // m: 2^-11 a level, docs/surface.md
        FunctionGrid source = new(16, (line, sample) => 1_737_400.0 + (4999.0 * Math.Sin((line * 0.01) + (sample * 0.7))));
        double[] radius = new double[1];
        LodLevels.Open(source).Level(4).ReadRadii(40, 200, radius);
        double[] fine = new double[16];
        decimal sum = 0;
        for (int line = 40 * 16; line < 41 * 16; line++)
        {
            source.ReadRadii(line, 200 * 16, fine);
            sum += fine.Sum(value => (decimal)value);
        }

        Assert.InRange(radius[0] - (double)(sum / 256), -Bound, Bound);
    }

    [Fact]
    public void ReadRadii_FromSourceOrFromTheLevelBelow_HasTheSameBits()
    {
        CountingGrid source = new(
            new FunctionGrid(8, (line, sample) => 1_737_400.0 + (9000.0 / 7.0 / (1 + ((line * 7919) + (sample * 104729)) % 20011))));
        double[] direct = Everything(LodLevels.Open(source).Level(3));
        LodLevels stepwise = LodLevels.Open(source);
        Everything(stepwise.Level(1));
        Everything(stepwise.Level(2));
        long before = source.SamplesRead;

        Assert.Equal(direct, Everything(stepwise.Level(3)));
        Assert.Equal(before, source.SamplesRead); // level 3 came from level 2, level 2 from level 1
    }

    [Fact]
    public void ReadRadii_SmallCache_KeepsFewBlocksAndTheSameValues()
    {
        const int BlockBytes = 64 * 64 * sizeof(float);
        CountingGrid source = new(FunctionGrid.Rough(8));
        IGlobalGrid small = LodLevels.Open(source, cacheBytes: 20 * BlockBytes).Level(1);
        double[] expected = OneOfEachBlock(LodLevels.Open(source).Level(1));
        Assert.Equal(expected, OneOfEachBlock(small));

        long before = source.SamplesRead;
        double[] last = new double[32];
        small.ReadRadii(719, 1408, last);
        Assert.Equal(before, source.SamplesRead); // the newest block is there
        small.ReadRadii(0, 0, last);
        Assert.Equal(before + (128 * 128), source.SamplesRead); // the oldest is not
    }

    [Fact]
    public void ReadRadii_BlockUsedAgainAndAgain_StaysInASmallCache()
    {
        CountingGrid source = new(FunctionGrid.Rough(16));
        IGlobalGrid grid = LodLevels.Open(source, cacheBytes: 0).Level(1); // the minimum: 8 blocks
        double[] radii = new double[1];
        for (int block = 0; block < 45; block++)
        {
            grid.ReadRadii(700, 0, radii);
            grid.ReadRadii(0, 64 * block, radii);
        }

        Assert.Equal(46 * 128 * 128, source.SamplesRead);
    }

    [Fact]
    public void ReadRadii_ManyThreadsAtOnce_ComputeABlockOnce()
    {
        CountingGrid source = new(FunctionGrid.Rough(64));
        IGlobalGrid grid = LodLevels.Open(source).Level(4);
        const int Threads = 8;
        using Barrier start = new(Threads);
        double[][] radii = [.. Enumerable.Range(0, Threads).Select(_ => new double[64])];
        Thread[] threads = [.. radii.Select(target => new Thread(() =>
        {
            start.SignalAndWait(TimeSpan.FromSeconds(60));
            grid.ReadRadii(70, 128, target);
        }))];
        Array.ForEach(threads, thread => thread.Start());
        Assert.All(threads, thread => Assert.True(thread.Join(TimeSpan.FromSeconds(120)), "a thread still reads"));

        Assert.Equal(1024 * 1024, source.SamplesRead);
        Assert.All(radii, other => Assert.Equal(radii[0], other));
    }

    [Fact]
    public void ReadRadii_AfterAFailure_ReadsAgain()
    {
        CountingGrid source = new(FunctionGrid.Rough(4)) { Fails = true };
        IGlobalGrid grid = LodLevels.Open(source).Level(1);
        double[] radii = new double[3];
        Assert.Throws<BadInputException>(() => grid.ReadRadii(0, 0, radii));
        source.Fails = false;

        grid.ReadRadii(0, 0, radii);

        Assert.All(radii, radius => Assert.InRange(radius, 1_732_000.0, 1_743_000.0));
    }

    [Theory]
    [InlineData(-1, 0, 1)]
    [InlineData(360, 0, 1)]
    [InlineData(0, 720, 1)]
    [InlineData(0, 0, 0)]
    [InlineData(0, 0, 721)]
    public void ReadRadii_OutsideTheGrid_Throws(int line, int firstSample, int count)
    {
        IGlobalGrid grid = LodLevels.Open(FunctionGrid.Rough(4)).Level(1);

        Assert.Throws<ArgumentOutOfRangeException>(() => grid.ReadRadii(line, firstSample, new double[count]));
    }

    [Fact]
    public void Open_StoredLevels_AreTakenByTheirResolution()
    {
        FunctionGrid stored = FunctionGrid.Hilly(2);
        LodLevels levels = LodLevels.Open(FunctionGrid.Rough(8), [stored]);

        Assert.Same(stored, levels.Level(2));
        Assert.NotSame(stored, levels.Level(1));
    }

    private static double[] OneOfEachBlock(IGlobalGrid grid)
    {
        LodLayout layout = new(grid.PixelsPerDegree);
        double[] radii = new double[layout.Blocks];
        for (int block = 0; block < radii.Length; block++)
        {
            grid.ReadRadii(
                block / layout.BlockColumns * LodLayout.Side, block % layout.BlockColumns * LodLayout.Side, radii.AsSpan(block, 1));
        }

        return radii;
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
}
