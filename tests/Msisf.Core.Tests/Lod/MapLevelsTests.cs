using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Lod;

public sealed class MapLevelsTests
{
    /// <summary>LDEM_80S_20M, LDEM_875S_5M, LDEM_45S_100M, a piece of 200 samples and one of 31.</summary>
    [Theory]
    [InlineData(30400, 20.0, 11)] // 20,480 m, 30 samples a side
    [InlineData(30336, 5.0, 11)]
    [InlineData(28800, 100.0, 11)]
    [InlineData(200, 5.0, 4)] // 40 m, 25 samples
    [InlineData(31, 5.0, 2)] // 10 m, 16 samples
    [InlineData(30, 5.0, 1)]
    public void Open_PolarMap_HalvesItWhileItsSidesHave16Samples(int side, double scale, int count)
    {
        double middle = 0.5 * (side - 1);
        MapLevels levels = MapLevels.Open(new EmptyMap(new PolarStereographic(true, scale, middle, middle), side));

        Assert.Equal(count, levels.Count);
        Assert.All(Enumerable.Range(0, count), level =>
            Assert.Equal(scale * (1 << level), levels.Grid(level).Projection.Resolution.MetresPerPixel));
    }

    /// <summary>1737.4 km from the pole is the limit of the bounds; half a cell of 2,000 m more is beyond it.</summary>
    [Fact]
    public void Open_MapThatReachesAsFarAsMapsMay_HasNoLevelThatReachesFarther()
    {
        const int Side = 3475; // 1737 km to each side of the middle
        MapLevels levels = MapLevels.Open(new EmptyMap(new PolarStereographic(true, 1000.0, 1737.0, 1737.0), Side));
        Assert.Equal(1, levels.Count);
    }

    [Theory]
    [InlineData(12, 3)]
    [InlineData(5, 1)]
    public void Open_BandOfDegrees_HalvesItWhileItsResolutionIsWhole(int resolution, int count)
    {
        WindowGrid band = new(FunctionGrid.Rough(resolution), new GridWindow(30 * resolution, 150 * resolution, 0, 360 * resolution));
        MapLevels levels = MapLevels.Open(band);

        Assert.Equal(count, levels.Count);
        Assert.Equal(new GridWindow(90, 450, 0, 1080), MapLevels.Open(new WindowGrid(
            FunctionGrid.Rough(6), new GridWindow(180, 900, 0, 2160))).Grid(1).Window);
    }

    /// <summary>By direct means of what there is, step by step, in whole 64ths of a metre.</summary>
    [Theory]
    [InlineData(140, 131)]
    [InlineData(133, 264)]
    public void ReadRadii_PolarMapOfAnySize_AreTheMeansOfItsSamples(int lines, int samples)
    {
        PolarFunctionGrid map = Rough(lines, samples);
        MapLevels levels = MapLevels.Open(map);
        double[,] expected = All(map);
        for (int level = 1; level <= 3; level++)
        {
            expected = Halved(expected, 0, 0);
            Assert.Equal(expected, All(levels.Grid(level)));
        }
    }

    /// <summary>A piece of a cylindrical model that begins and ends at odd lines and samples.</summary>
    [Fact]
    public void ReadRadii_PieceAtOddLines_AreTheMeansOfItsSamples()
    {
        WindowGrid piece = new(FunctionGrid.Rough(8), new GridWindow(331, 490, 1123, 1300));
        ITerrainGrid level = MapLevels.Open(piece).Grid(1);

        Assert.Equal(new GridWindow(165, 245, 561, 650), level.Window);
        Assert.Equal((720, 1440), (level.Lines, level.Samples));
        Assert.Equal(Halved(All(piece), 331, 1123), All(level));
        ITerrainGrid next = MapLevels.Open(piece).Grid(2);
        Assert.Equal(Halved(All(level), 165, 561), All(next));
    }

    [Fact]
    public void ReadRadii_BandAcrossThePrimeMeridian_GoesAround()
    {
        FunctionGrid whole = FunctionGrid.Rough(4);
        WindowGrid band = new(whole, new GridWindow(120, 600, 0, 1440));
        double[] expected = new double[100];
        double[] found = new double[100];
        LodLevels.Open(whole).Level(1).ReadRadii(77, 690, expected);
        MapLevels.Open(band).Grid(1).ReadRadii(77, 690, found);
        Assert.Equal(expected, found);
    }

    /// <summary>What is kept of a map serves it at another place and another height too: no sample of it is read.</summary>
    [Fact]
    public void Open_MapThatIsMoved_HasTheLevelsThatAreKept()
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(isSouth: true, 100.0, 64, -700.0, 400.0);
        MapLevels computed = MapLevels.Open(map);
        KeptMap kept = new(map, [computed.Grid(1), computed.Grid(2)]);
        ITerrainGrid shifted = MapLevels.Open(ShiftedGrid.Of(kept, 300.0, -120.0)).Grid(2);
        ITerrainGrid expected = MapLevels.Open(ShiftedGrid.Of(map, 300.0, -120.0)).Grid(2);

        Assert.Equal(expected.Projection, shifted.Projection);
        Assert.Equal(All(expected), All(shifted));
        double[,] own = All(computed.Grid(2));
        double[,] raised = All(MapLevels.Open(new OffsetGrid(kept, 7.25)).Grid(2));
        Assert.All(Enumerable.Range(0, 16), i => Assert.Equal(own[i, 15 - i] + 7.25, raised[i, 15 - i]));
    }

    [Fact]
    public void ReadRadii_FromTheMapOrFromTheLevelBelow_HasTheSameBits()
    {
        PolarFunctionGrid map = new(
            new PolarStereographic(true, 20.0, 700.0, 90.0), 411, 365,
            (line, sample) => 9000.0 / 7.0 / (1 + (((line * 7919) + (sample * 104729)) % 20011)));
        double[,] direct = All(MapLevels.Open(map).Grid(3));
        MapLevels stepwise = MapLevels.Open(map);
        All(stepwise.Grid(1));
        All(stepwise.Grid(2));

        Assert.Equal(direct, All(stepwise.Grid(3)));
    }

    [Theory]
    [InlineData(true, 1)]
    [InlineData(false, 3)]
    public void Projection_OfALevel_PutsASampleInTheMiddleOfThoseItReplaces(bool isSouth, int level)
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(isSouth, 200.0, 150, 31.0, 170.5);
        MapProjection coarse = MapLevels.Open(map).Grid(level).Projection;
        double toMiddle = 0.5 * ((1 << level) - 1);
        foreach ((int line, int sample) in new[] { (0, 0), (7, 11), (18, 3) })
        {
            Vector3D middle = map.Projection.DirectionOf((line << level) + toMiddle, (sample << level) + toMiddle);
            // 2 ulps of a unit vector: the offsets are exact
            Assert.InRange((coarse.DirectionOf(line, sample) - middle).Length, 0.0, 4e-16);
        }
    }

    [Theory]
    [InlineData(-1, 0, 1)]
    [InlineData(75, 0, 1)]
    [InlineData(0, 71, 1)]
    [InlineData(0, 0, 72)]
    [InlineData(0, 70, 2)]
    [InlineData(0, 0, 0)]
    public void ReadRadii_OutsideTheMap_Throws(int line, int firstSample, int count)
    {
        ITerrainGrid level = MapLevels.Open(Rough(150, 141)).Grid(1);
        Assert.Throws<ArgumentOutOfRangeException>(() => level.ReadRadii(line, firstSample, new double[count]));
    }

    /// <summary>From 100 km with pixels of 71 m an error of 0.35 px allows cells of 50 m: 40 m.</summary>
    [Theory]
    [InlineData(100e3, 1, 1)]
    [InlineData(100e3, 2, 0)]
    [InlineData(50e3, 1, 0)]
    [InlineData(900e3, 1, 4)]
    [InlineData(-1e3, 1, 0)]
    public void LevelOfImage_Ldem80S20M_IsTheWidestCellWithinTheError(double height, int subsamplesPerAxis, int level)
    {
        MapLevels levels = MapLevels.Open(new EmptyMap(new PolarStereographic(true, 20.0, 15199.5, 15199.5), 30400));
        Vector3D position = -(MoonConstants.ReferenceRadius + height) * Vector3D.UnitZ;
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), double.DegreesToRadians(40.0), 1024, 1024);
        Assert.Equal(
            level, new DetailRule(levels, DetailRule.DefaultError).LevelOfImage(camera.Footprint, subsamplesPerAxis));
    }

    private static PolarFunctionGrid Rough(int lines, int samples) => new(
        new PolarStereographic(true, 20.0, 50.0, 50.0), lines, samples,
        (line, sample) => 0.5 * ((((line * 7919) + (sample * 104729)) % 8001) - 4000));

    /// <summary>Means of 2 x 2 of a part of a grid that begins at a line and a sample.</summary>
    private static double[,] Halved(double[,] fine, int firstLine, int firstSample)
    {
        (int lines, int samples) = (fine.GetLength(0), fine.GetLength(1));
        (int top, int left) = (firstLine / 2, firstSample / 2);
        double[,] coarse = new double[((firstLine + lines + 1) / 2) - top, ((firstSample + samples + 1) / 2) - left];
        for (int i = 0; i < coarse.GetLength(0); i++)
        {
            for (int j = 0; j < coarse.GetLength(1); j++)
            {
                int[] ys = [.. new[] { 2 * (top + i), (2 * (top + i)) + 1 }.Select(y => Math.Clamp(y - firstLine, 0, lines - 1))];
                int[] xs = [.. new[] { 2 * (left + j), (2 * (left + j)) + 1 }.Select(x => Math.Clamp(x - firstSample, 0, samples - 1))];
                coarse[i, j] = (double)((from y in ys from x in xs select (decimal)fine[y, x]).Sum() / 4);
            }
        }

        return coarse;
    }

    private static double[,] All(ITerrainGrid grid)
    {
        GridWindow window = grid.Window;
        double[,] radii = new double[window.Lines, window.Samples];
        double[] line = new double[window.Samples];
        for (int i = 0; i < window.Lines; i++)
        {
            grid.ReadRadii(window.FirstLine + i, window.FirstSample, line);
            for (int j = 0; j < line.Length; j++)
            {
                radii[i, j] = line[j];
            }
        }

        return radii;
    }

    /// <summary>A map without samples.</summary>
    private sealed class EmptyMap(PolarStereographic projection, int side) : ITerrainGrid
    {
        public string ProductId => "EMPTY";

        public MapProjection Projection => projection;

        public int Lines => side;

        public int Samples => side;

        public void ReadRadii(int line, int firstSample, Span<double> radii) => throw new NotSupportedException();
    }

    /// <summary>A map whose levels were computed before, and whose samples can't be read.</summary>
    private sealed class KeptMap(ITerrainGrid map, IReadOnlyList<ITerrainGrid> levels) : ITerrainGrid
    {
        public string ProductId => map.ProductId;

        public MapProjection Projection => map.Projection;

        public int Lines => map.Lines;

        public int Samples => map.Samples;

        public IReadOnlyList<ITerrainGrid> StoredLevels => levels;

        public void ReadRadii(int line, int firstSample, Span<double> radii) => throw new NotSupportedException();
    }
}
