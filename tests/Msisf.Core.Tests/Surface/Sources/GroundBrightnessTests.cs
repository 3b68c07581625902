using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

public sealed class GroundBrightnessTests
{
    private const int Coarse = 5;

    /// <summary>A window of cells of 32 m around one of 16 m, away from the map's middle and across tiles of both signs.</summary>
    private static WindowPlace[] PlacesOn(LatticeFace face) =>
    [
        new(face, Coarse, new CellRange(-160, 224, 9_600, 10_048)),
        new(face, Coarse - 1, new CellRange(-96, 160, 19_520, 19_840)),
    ];

    /// <summary>
    /// On all six maps: the factor of the finest window that holds the place, linear between the samples of the lattice twice as wide;
    /// at any radius.
    /// </summary>
    [Theory]
    [InlineData(0, false)]
    [InlineData(0, true)]
    [InlineData(1, false)]
    [InlineData(1, true)]
    [InlineData(2, false)]
    [InlineData(2, true)]
    public void Scale_PlacesInWindows_HaveTheFactorsOfTheFinest(int turn, bool isSouth)
    {
        LatticeFace face = new(turn, isSouth);
        Random random = new(turn);
        for (int number = 0; number < 400; number++)
        {
            bool isFine = number % 2 == 0; // beside the inner window, 40 cells and more within the outer one
            (double line, double sample) = isFine
                ? ((16.0 * -96) + (random.NextDouble() * 16.0 * 256), (16.0 * 19_520) + (random.NextDouble() * 16.0 * 320))
                : ((32.0 * 90) + (random.NextDouble() * 32.0 * 90), (32.0 * 9_650) + (random.NextDouble() * 32.0 * 350));
            int level = isFine ? Coarse : Coarse + 1;
            double cell = Math.ScaleB(1.0, level);
            (double y, double x) = (line / cell, sample / cell);
            (double row, double column) = (Math.Floor(y), Math.Floor(x));
            double expected = 0.0;
            foreach ((int down, int right) in new[] { (0, 0), (0, 1), (1, 0), (1, 1) })
            {
                double weight = (down == 0 ? row + 1.0 - y : y - row) * (right == 0 ? column + 1.0 - x : x - column);
                expected += weight * ValueAt(level, (int)row + down, (int)column + right);
            }

            // values are floats, of about 7
            Assert.Equal(7.0 * expected, Scaled(face, line, sample, 1_735_000.0 + (random.NextDouble() * 5e3), 7.0), 2e-6);
        }
    }

    /// <summary>Along the border of the coarsest window the factors go over into 1 over 24 cells, and beyond it nothing changes.</summary>
    [Theory]
    [InlineData(-0.5, 0.0)]
    [InlineData(0.5, 0.5 / 24.0)]
    [InlineData(6.0, 0.25)]
    [InlineData(23.9, 23.9 / 24.0)]
    [InlineData(25.0, 1.0)]
    public void Scale_BorderOfTheCoarsestWindow_GoesOverIntoOne(double cells, double part)
    {
        LatticeFace face = new(1, false);
        double line = 32.0 * (224 - cells);
        double sample = 32.0 * 9_700;
        double inside = ValueBetween(Coarse + 1, line / 64.0, (int)(sample / 64.0));
        Assert.Equal(1.0 + (part * (inside - 1.0)), Scaled(face, line, sample, 1_737_000.0, 1.0), 2e-6);
    }

    private static double ValueBetween(int level, double row, int column)
    {
        int above = (int)Math.Floor(row);
        return ((above + 1 - row) * ValueAt(level, above, column)) + ((row - above) * ValueAt(level, above + 1, column));
    }

    private static float ValueAt(int level, int line, int sample) =>
        1.0f + (0.01f * level) + (0.3f * MathF.Sin(1.3f * line) * MathF.Cos((0.7f * (sample % 4096)) + level));

    private static double Scaled(LatticeFace face, double line, double sample, double radius, double reflectance)
    {
        Vector3D place = radius * face.Map(0).DirectionOf(line, sample).Normalized();
        Vector3D other = radius * face.Map(0).DirectionOf(32.0 * 200, 32.0 * 10_000).Normalized();

        // Among others: blocks of places are computed at once, and each starts from the window of the one before.
        double[] x = [.. Enumerable.Repeat(other.X, 66), place.X, other.X];
        double[] y = [.. Enumerable.Repeat(other.Y, 66), place.Y, other.Y];
        double[] z = [.. Enumerable.Repeat(other.Z, 66), place.Z, other.Z];
        double[] reflectances = [.. Enumerable.Repeat(reflectance, 68)];
        new GroundBrightness(new DetailTiles<float>(1 << 20, Read), PlacesOn(face)).Scale(x, y, z, reflectances);
        Assert.Equal(reflectances[0], reflectances[67]);
        return reflectances[66];
    }

    private static void Read(PolarStereographic map, int firstLine, int firstSample, int side, Span<float> values)
    {
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = ValueAt((int)Math.Log2(map.MetresPerPixel), firstLine + (i / side), firstSample + (i % side));
        }
    }
}
