using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class MapSynthesizerTests
{
    private const int Side = 200;

    /// <summary>
    /// At samples of the map, the ground of the cylindrical model of the same seed, between the two samples beside it on each axis: it is
    /// within their heights and what the shortest waves may do between them.
    /// </summary>
    [Theory]
    [InlineData(true, false)]
    [InlineData(false, false)]
    [InlineData(true, true)]
    public void Synthesize_Map_IsTheGroundOfTheCylindricalModel(bool isSouth, bool hasBase)
    {
        const int Resolution = 16;
        double scale = MoonConstants.ReferenceRadius * Math.PI / 180.0 / Resolution;
        FunctionGrid? baseModel = hasBase ? FunctionGrid.Hilly(4) : null;
        PolarStereographic map = new(isSouth, scale, 0.5 * (Side - 1), 0.5 * (Side - 1));
        float[] heights = new float[Side * Side];
        new MapSynthesizer(SyntheticTerrain.ForMap(scale, 3, baseModel), map).Synthesize(0, Side, 0, Side, heights);
        TileSynthesizer tiles = new(new SyntheticTerrain(Resolution, 3, baseModel));
        Equirectangular cylinder = new(Resolution);
        float[] four = new float[4];
        double squared = 0.0;
        double relief = 0.0;
        int count = 0;
        Random random = new(20120222);
        for (int number = 0; number < 300; number++)
        {
            (int line, int sample) = (random.Next(Side), random.Next(Side));
            (double atLine, double atSample) = cylinder.PixelOf(map.DirectionOf(line, sample));
            if (atSample < 0.0 || atSample >= (360 * Resolution) - 1 || atLine < 1.0 || atLine >= (180 * Resolution) - 2)
            {
                continue;
            }

            (int north, int west) = ((int)atLine, (int)atSample);
            tiles.Synthesize(north, 2, west, 2, four);
            (double down, double right) = (atLine - north, atSample - west);
            double expected = ((1.0 - down) * (((1.0 - right) * four[0]) + (right * four[1])))
                + (down * (((1.0 - right) * four[2]) + (right * four[3])));
            double found = heights[(line * Side) + sample];
            squared += (found - expected) * (found - expected);
            relief += found * found;
            count++;
        }

        // Another ground of the same statistics would differ by sqrt(2) times the relief.
        Assert.InRange(count, 250, 300);
        Assert.InRange(Math.Sqrt(squared / count), 0.0, 0.2 * Math.Sqrt(relief / count));
    }

    [Fact]
    public void Synthesize_AnyBlock_GivesTheSameHeights()
    {
        PolarStereographic map = new(true, 500.0, 99.5, 99.5);
        SyntheticTerrain terrain = SyntheticTerrain.ForMap(500.0, 5, null);
        float[] whole = new float[Side * Side];
        new MapSynthesizer(terrain, map).Synthesize(0, Side, 0, Side, whole);
        MapSynthesizer other = new(terrain, map);
        float[] block = new float[37 * 41];
        foreach ((int line0, int sample0) in new[] { (0, 0), (80, 77), (163, 159), (3, 150) })
        {
            other.Synthesize(line0, 37, sample0, 41, block);
            for (int line = 0; line < 37; line++)
            {
                Assert.Equal(whole.AsSpan(((line0 + line) * Side) + sample0, 41).ToArray(), block.AsSpan(line * 41, 41).ToArray());
            }
        }
    }
}
