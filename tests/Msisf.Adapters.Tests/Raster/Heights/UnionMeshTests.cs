using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>
/// A real map of 5 m in LDEM_4, which lies 47 m above it in the mean: rays of the exact tracer through all facets of both together. The
/// Suns are those of tests/reference/nested_light.py, whose images show the same shares.
/// </summary>
public sealed class UnionMeshTests
{
    private const int Border = 64; // samples along each side that do not count
    private const int Side = 400;

    /// <summary>The map's inner ground is as lit in LDEM_4 as alone, facet by facet; at the numbers that its images have.</summary>
    [RequiresTheory(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    [InlineData(-1.386442664927036E+11, 4.826867680243302E+10, -2.677467859710887E+09, 77.50)]
    [InlineData(-1.460566197520366E+11, -1.443318883635064E+10, -2.784087706516914E+09, 66.99)]
    [InlineData(-1.365750826974195E+11, -5.377082533711362E+10, -2.843108678425051E+09, 53.52)]
    public void IsHidden_RealMapInLowerGround_IsAsAlone(double x, double y, double z, double expected)
    {
        using GeoTiffGrid map = GeoTiffGrid.Open(TestParts.PolarPiece("NPC")!, libraryPath: null);
        using LdemImage moon = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        TerrainTracer alone = new(map);
        TerrainTracer union = new(new NestedTerrain([moon, map]));
        Vector3D sun = new(x, y, z);
        int step = TestLength.Of(8, 1);
        (int places, int litAlone, int litInMoon, int others) = (0, 0, 0, 0);
        for (int line = Border; line < Side - Border; line += step)
        {
            for (int sample = Border; sample < Side - Border; sample += step)
            {
                bool isLitAlone = IsLit(alone, map, line, sample, 0, sun);
                bool isLitInMoon = IsLit(union, map, line, sample, 1, sun);
                places++;
                litAlone += isLitAlone ? 1 : 0;
                litInMoon += isLitInMoon ? 1 : 0;
                others += isLitAlone != isLitInMoon ? 1 : 0;
            }
        }

        Assert.InRange(100.0 * litInMoon / places, (100.0 * litAlone / places) - 1.0, (100.0 * litAlone / places) + 1.0);
        Assert.InRange(100.0 * litAlone / places, expected - TestLength.Of(3, 1), expected + TestLength.Of(3, 1));
        Assert.InRange(100.0 * others / places, 0.0, 1.0);
    }

    /// <summary>Whether the ground in the middle of a cell is lit; the ray down meets the map's facet there, in the union too.</summary>
    private static bool IsLit(TerrainTracer tracer, GeoTiffGrid map, int line, int sample, int part, Vector3D sun)
    {
        Vector3D up = map.Projection.DirectionOf(line + 0.3, sample + 0.6).Normalized();
        Assert.True(tracer.TryTrace(new Ray(1_760_000.0 * up, -1.0 * up), out SurfaceHit hit));
        Assert.Equal((part, line, sample), (hit.Facet.Part, hit.Facet.Line, hit.Facet.Sample));
        return !tracer.IsHidden(hit.PointBodyFixed, hit.Facet, sun);
    }
}
