using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class GroundDetailTests
{
    private const ulong Seed = 20120222;

    /// <summary>m: detail is kept as 32-bit floats, and is up to some km high.</summary>
    private const double DetailInFloats = 2e-3;

    /// <summary>
    /// 17 degrees: the difference changes along the border as the ground does, whose slopes have a median of 7.5 degrees.
    /// </summary>
    private const double MostSlopeOfChange = 0.3;

    private static readonly FunctionGrid Moon = FunctionGrid.Hilly(4);

    private static readonly GroundDetail OfMoon = new(Seed, [Moon]);

    /// <summary>The model's low frequencies stay: its samples keep their heights, whatever the cells are.</summary>
    [Theory]
    [InlineData(0.0625)]
    [InlineData(1.0)]
    [InlineData(64.0)]
    [InlineData(2048.0)]
    public void RadiusAt_SampleOfTheModel_IsItsOwn(double cell)
    {
        Random random = new(5);
        double[] radius = new double[1];
        for (int number = 0; number < 25; number++)
        {
            (int line, int sample) = (random.Next(4 * 20, 4 * 160), random.Next(1440)); // 70 degrees south to 70 north
            Moon.ReadRadii(line, sample, radius);
            double found = OfMoon.RadiusAt(((ITerrainGrid)Moon).Projection.DirectionOf(line, sample), cell);
            Assert.InRange(found - radius[0], -2e-3, 2e-3); // detail is kept as 32-bit floats, and is up to some km high
        }
    }

    /// <summary>Of a model that holds means, the mean of the ground over each cell is the model's own; here of 48 x 48 places.</summary>
    [Fact]
    public void RadiusAt_ModelOfMeans_HasTheMeansOfItsCells()
    {
        GridOfMeans means = new(Moon);
        GroundDetail ground = new(Seed, [means]);
        double[] radius = new double[1];
        foreach ((int line, int sample) in new[] { (360, 700), (150, 1), (421, 1439) }.Take(TestLength.Of(2, 3)))
        {
            const int Side = 48;
            double sum = 0.0;
            for (int i = 0; i < Side * Side; i++)
            {
                sum += ground.RadiusAt(
                    ((ITerrainGrid)means).Projection.DirectionOf(
                        line - 0.5 + (((i / Side) + 0.5) / Side), sample - 0.5 + (((i % Side) + 0.5) / Side)), 128.0);
            }

            Moon.ReadRadii(line, sample, radius);
            Assert.InRange((sum / (Side * Side)) - radius[0], -2.0, 2.0); // its samples would be some 100 m off
        }
    }

    /// <summary>A map's samples keep their heights up to its border, and to the border of places without data.</summary>
    [Theory]
    [InlineData(0.5, false)]
    [InlineData(32.0, false)]
    [InlineData(32.0, true)]
    public void RadiusAt_SampleOfAMapInside_IsItsOwn(double cell, bool hasGaps)
    {
        const int Side = 120;
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 100.0, Side, 59.5, 59.5);
        GroundDetail ground = new(Seed, [Moon, hasGaps ? new GridWithHole(map) : map]);
        double[] radius = new double[1];
        for (int place = 0; place < Side; place += 7)
        {
            foreach ((int line, int sample) in new[]
                { (0, place), (place, Side - 1), (place, 1), (59, place), (GridWithHole.First - 1, place) })
            {
                if (hasGaps && GridWithHole.IsHole(line, sample))
                {
                    continue;
                }

                map.ReadRadii(line, sample, radius);
                Assert.InRange(ground.RadiusAt(map.Polar.DirectionOf(line, sample), cell) - radius[0], -DetailInFloats, DetailInFloats);
            }
        }
    }

    /// <summary>A map of means keeps them to a centimetre, also in its corner; here of 32 x 32 places a cell.</summary>
    [Fact]
    public void RadiusAt_MapOfMeansInside_HasTheMeansOfItsCells()
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 20.0, 60, 29.5, 29.5);
        GroundDetail ground = new(Seed, [Moon, new GridWithHole(map, holdsMeans: true)]);
        double[] radius = new double[1];
        foreach ((int line, int sample) in new[] { (0, 0), (59, 20), (17, 31) })
        {
            const int Places = 32;
            double sum = 0.0;
            for (int i = 0; i < Places * Places; i++)
            {
                sum += ground.RadiusAt(
                    map.Polar.DirectionOf(
                        line - 0.5 + (((i / Places) + 0.5) / Places), sample - 0.5 + (((i % Places) + 0.5) / Places)), 8.0);
            }

            map.ReadRadii(line, sample, radius);
            Assert.InRange((sum / (Places * Places)) - radius[0], -0.01, 0.01);
        }
    }

    /// <summary>
    /// The ground beside a map goes over into that of the coarser model without a step; far away it is that of the model alone.
    /// </summary>
    [Fact]
    public void RadiusAt_BesideAMap_GoesOverIntoTheCoarserModel()
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 100.0, 120, 59.5, 59.5);
        GroundDetail ground = new(Seed, [Moon, map]);
        Vector3D far = map.Polar.DirectionOf(60.0, -40_000.0);
        Assert.Equal(OfMoon.RadiusAt(far, 32.0), ground.RadiusAt(far, 32.0));
        double before = ground.RadiusAt(map.Polar.DirectionOf(60.0, -20.0), 32.0);
        for (double sample = -19.98; sample < 20.0; sample += 0.02)
        {
            double here = ground.RadiusAt(map.Polar.DirectionOf(60.0, sample), 32.0);
            Assert.InRange(here - before, -4.0, 4.0); // m in 2 m: slopes up to some 60 degrees, which the map has
            before = here;
        }
    }

    /// <summary>
    /// What a flat map in a flat Moon changes around it is no steeper than the ground itself, and dies away within the map's own width.
    /// </summary>
    [Fact]
    public void RadiusAt_BesideAFlatMap_IsTheGroundOfTheMoonAndASmoothChange()
    {
        FunctionGrid flat = new(4, (_, _) => MoonConstants.ReferenceRadius);
        PolarFunctionGrid map = new(new PolarStereographic(true, 5.0, 99.5, 99.5), 200, 200, (_, _) => 0.0);
        GroundDetail alone = new(Seed, [flat]);
        GroundDetail ground = new(Seed, [flat, map]);
        double[] changes = [.. Enumerable.Range(0, 250).Select(number =>
        {
            Vector3D place = map.Polar.DirectionOf(100.0, -4.0 - (4.0 * number));
            return ground.RadiusAt(place, 1.0) - alone.RadiusAt(place, 1.0);
        })];
        Assert.Contains(changes, change => Math.Abs(change) > 1.0);
        for (int number = 1; number < changes.Length; number++)
        {
            Assert.InRange(Math.Abs(changes[number] - changes[number - 1]), 0.0, 4.0 * MostSlopeOfChange);
        }

        Assert.Equal(0.0, changes[^1]);
    }

    /// <summary>A block has the heights of its places, and so of any other block that holds them.</summary>
    [Theory]
    [InlineData(0, false, 0.25, 20_000, -40_000)]
    [InlineData(1, false, 16.0, 11_000, -7_000)]
    [InlineData(2, true, 512.0, -1_200, 800)]
    [InlineData(0, true, 1.0, -30, -20)]
    public void ReadRadii_Block_HasTheHeightsOfItsPlaces(int turn, bool isSouth, double cell, int line, int sample)
    {
        PolarStereographic map = new(isSouth, cell, 0.0, 0.0) { Turn = turn };
        double[] radii = new double[64 * 64];
        OfMoon.ReadRadii(map, line, sample, 64, radii);
        double[] beside = new double[64 * 64];
        OfMoon.ReadRadii(map, line + 32, sample - 16, 64, beside);
        for (int i = 0; i < 32; i++)
        {
            for (int j = 0; j < 48; j++)
            {
                Assert.Equal(radii[((i + 32) * 64) + j], beside[(i * 64) + j + 16], 1e-3);
            }
        }

        for (int i = 0; i < radii.Length; i += 331)
        {
            double expected = OfMoon.RadiusAt(map.DirectionOf(line + (i / 64), sample + (i % 64)), cell);
            Assert.Equal(expected, radii[i], 1e-3); // m: detail is computed in floats
        }
    }

    /// <summary>
    /// Near and far agree: cells half as wide add hills and craters of some cells only, whose heights are a small part of a cell in the
    /// mean; the finest craters, of four cells, are as deep as 0.8 cells.
    /// </summary>
    [Theory]
    [InlineData(0.5)]
    [InlineData(8.0)]
    [InlineData(128.0)]
    public void RadiusAt_CellsHalfAsWide_DiffersByAPartOfACell(double cell)
    {
        Random random = new(7);
        double squared = 0.0;
        const int Count = 150;
        for (int number = 0; number < Count; number++)
        {
            Vector3D direction = new Vector3D(1.0, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();
            double difference = OfMoon.RadiusAt(direction, cell) - OfMoon.RadiusAt(direction, 0.5 * cell);
            Assert.InRange(Math.Abs(difference), 0.0, 0.8 * cell);
            squared += difference * difference;
        }

        Assert.InRange(Math.Sqrt(squared / Count), 0.002 * cell, 0.15 * cell);
    }

    [Fact]
    public void RadiusAt_AnotherSeed_IsOtherGroundOfTheSameModel()
    {
        Vector3D direction = new Vector3D(0.8, 0.1, 0.2).Normalized();
        double difference = OfMoon.RadiusAt(direction, 1.0) - new GroundDetail(Seed + 1, [Moon]).RadiusAt(direction, 1.0);
        Assert.InRange(Math.Abs(difference), 1e-3, 3000.0);
    }

    /// <summary>Over metres the ground is about as rough as the law says: 7.5 degrees in the median at 17 m on highlands.</summary>
    [Fact]
    public void RadiusAt_Highlands_AreAsRoughAsTheLaw()
    {
        const double Baseline = 17.0;
        Random random = new(11);
        List<double> slopes = [];
        for (int number = 0; number < 300; number++)
        {
            Vector3D direction = new Vector3D(-1.0, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();
            Vector3D east = new Vector3D(-direction.Y, direction.X, 0.0).Normalized();
            Vector3D north = Vector3D.Cross(direction, east);
            slopes.Add(double.Hypot(Along(direction, east), Along(direction, north)));
        }

        slopes.Sort();
        double law = SlopeLaw.Highlands.TangentAt(Baseline);
        Assert.InRange(slopes[slopes.Count / 2], 0.6 * law, 1.4 * law);

        static double Along(Vector3D direction, Vector3D side)
        {
            double half = 0.5 * Baseline / MoonConstants.ReferenceRadius;
            return (OfMoon.RadiusAt((direction + (half * side)).Normalized(), 2.0)
                - OfMoon.RadiusAt((direction - (half * side)).Normalized(), 2.0)) / Baseline;
        }
    }

    /// <summary>Fine lattices have more steps in a radius of the Moon than a 32-bit float counts.</summary>
    [Fact]
    public void Octave_OfCentimetres_IsSmooth()
    {
        NoiseOctave octave = new(Seed, 0.0625, 1.0, 1.0);
        Vector3D start = new Vector3D(0.6, -0.7, 0.3).Normalized();
        double[] heights = [.. Enumerable.Range(0, 2000).Select(step => At(start + (step * 1e-3 / 1.7374e6 * Vector3D.UnitZ)))];
        Assert.True(heights.Max() - heights.Min() > 0.5);
        for (int i = 1; i < heights.Length; i++)
        {
            Assert.InRange(heights[i] - heights[i - 1], -0.06, 0.06); // 1 mm of 62.5 mm
        }

        double At(Vector3D direction)
        {
            double[] x = [.. Enumerable.Repeat(direction.X, 8)];
            double[] y = [.. Enumerable.Repeat(direction.Y, 8)];
            double[] z = [.. Enumerable.Repeat(direction.Z, 8)];
            float[] height = new float[8];
            octave.AddTo(x, y, z, new float[8], height);
            return height[3];
        }
    }

    /// <summary>A model whose samples are means of cells.</summary>
    private sealed class GridOfMeans(IGlobalGrid grid) : IGlobalGrid
    {
        public string ProductId => grid.ProductId;

        public int PixelsPerDegree => grid.PixelsPerDegree;

        public bool HoldsMeans => true;

        public void ReadRadii(int line, int firstSample, Span<double> radii) => grid.ReadRadii(line, firstSample, radii);
    }

    /// <summary>A map with a square hole, or of means.</summary>
    private sealed class GridWithHole(ITerrainGrid grid, bool holdsMeans = false) : ITerrainGrid
    {
        public const int First = 40;

        public string ProductId => grid.ProductId;

        public MapProjection Projection => grid.Projection;

        public int Lines => grid.Lines;

        public int Samples => grid.Samples;

        public (double Min, double Max) RadiusLimits => grid.RadiusLimits;

        public bool HoldsMeans => holdsMeans;

        public bool MayHaveGaps => !holdsMeans;

        public static bool IsHole(int line, int sample) => line is >= First and < First + 10 && sample is >= First and < First + 10;

        public void ReadGaps(int line, int firstSample, Span<bool> isGap)
        {
            for (int i = 0; i < isGap.Length; i++)
            {
                isGap[i] = IsHole(line, firstSample + i);
            }
        }

        public void ReadRadii(int line, int firstSample, Span<double> radii)
        {
            for (int i = 0; i < radii.Length && MayHaveGaps; i++)
            {
                Assert.False(IsHole(line, firstSample + i));
            }

            grid.ReadRadii(line, firstSample, radii);
        }
    }

    /// <summary>Rays make no ground brighter in the mean; on highlands and maria, and at all widths of cells.</summary>
    [Theory]
    [InlineData(0.25)]
    [InlineData(64.0)]
    public void ReadBrightness_LargeArea_IsOneInTheMean(double cell)
    {
        const int Side = 64;
        PolarStereographic map = new(false, cell, 0.0, 0.0) { Turn = 1 };
        Random random = new(8);
        List<float> all = [];
        float[] factors = new float[Side * Side];
        for (int block = 0; block < TestLength.Of(250, 10_000); block++)
        {
            int Far() => (int)(800e3 * ((2.0 * random.NextDouble()) - 1.0) / cell); // 800 km, so that the largest craters' rays are there
            OfMoon.ReadBrightness(map, Far(), Far(), Side, factors);
            all.AddRange(factors);
        }

        Assert.Equal(1.0, all.Average(), TestLength.Of(5, 1) * 0.01);
        Assert.True(all.Max() > 1.5 && all.Min() < 0.999, $"{all.Min()} to {all.Max()}");
    }

    /// <summary>A place has its factor whatever block it is computed in, also beside a map inside.</summary>
    [Fact]
    public void ReadBrightness_OtherBlocks_AreTheSame()
    {
        PolarFunctionGrid inside = PolarFunctionGrid.Rugged(true, 100.0, 120, 59.5, 59.5);
        GroundDetail ground = new(Seed, [Moon, inside]);
        PolarStereographic map = new(true, 16.0, 0.0, 0.0);
        float[] whole = new float[512 * 512];
        ground.ReadBrightness(map, 200, -160, 512, whole);
        float[] part = new float[64 * 64];
        foreach ((int line, int sample) in new[] { (0, 0), (64, 128), (448, 448), (128, 320) })
        {
            ground.ReadBrightness(map, 200 + line, sample - 160, 64, part);
            for (int i = 0; i < part.Length; i++)
            {
                Assert.Equal(whole[((line + (i / 64)) * 512) + sample + (i % 64)], part[i], 1e-5f);
            }
        }

        Assert.True(whole.Max() - whole.Min() > 0.2f);
    }
}
