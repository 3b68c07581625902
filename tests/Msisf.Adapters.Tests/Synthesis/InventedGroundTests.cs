using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Synthesis;

/// <summary>Invented detail in LDEM_4 around LOLA's maps of 5 m, which lie up to 80 m off it.</summary>
public sealed class InventedGroundTests
{
    /// <summary>m: detail is kept as 32-bit floats, and is up to some km high.</summary>
    private const double DetailInFloats = 2e-3;

    /// <summary>All measured heights stay, to the outermost samples.</summary>
    [RequiresTheory(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    [InlineData("NPB", 1.0)]
    [InlineData("NPC", 1.0)]
    [InlineData("NPC", 0.0625)]
    public void RadiusAt_SamplesOfARealMap_AreTheMeasuredOnes(string piece, double cell)
    {
        using GeoTiffGrid map = GeoTiffGrid.Open(TestParts.PolarPiece(piece)!, libraryPath: null);
        using LdemImage moon = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        IGroundDetail ground = InventedGround.Of(7, new NestedTerrain([moon, map]).Grounds);
        double[] radii = new double[map.Samples];
        double greatest = 0.0;
        for (int line = 0; line < map.Lines; line++)
        {
            map.ReadRadii(line, 0, radii);
            for (int sample = 0; sample < map.Samples; sample++)
            {
                bool isOutermost = line == 0 || line == map.Lines - 1 || sample == 0 || sample == map.Samples - 1;
                if (((line * map.Samples) + sample) % TestLength.Of(isOutermost ? 11 : 31, 1) == 0)
                {
                    double found = ground.RadiusAt(map.Projection.DirectionOf(line, sample), cell);
                    greatest = Math.Max(greatest, Math.Abs(found - radii[sample]));
                }
            }
        }

        Assert.InRange(greatest, 0.0, DetailInFloats);
    }
}
