using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>Images of a polar map's levels against those of the map itself.</summary>
public sealed class PolarMapLevelTests
{
    private const int Side = 56; // px
    private const double Cell = 100.0; // m

    /// <summary>
    /// A pixel has 3.2 x 3.2 cells. The truth is the mean of 8 x 8 samples of the map: the level that the rule takes has to be as close to
    /// it as the map itself with one sample; the level beyond the rule's is not taken.
    /// </summary>
    [Theory]
    [InlineData(25.0)]
    [InlineData(8.0)]
    public void Render_LevelOfTheRule_IsAsCloseToTheTruthAsTheMap(double sunElevation)
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, Cell, 221, 110.0, 110.0);
        MapLevels levels = MapLevels.Open(map);
        double height = 3.2 * Cell * Side / (2.0 * Math.Tan(double.DegreesToRadians(20.0)));
        Vector3D position = -(MoonConstants.ReferenceRadius + height) * Vector3D.UnitZ;
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), double.DegreesToRadians(40.0), Side, Side);
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(sunElevation));
        SceneLight sun = new(1.5e11 * new Vector3D(cosine, 0.0, -sine), IsSun: true);
        int level = new DetailRule(levels, DetailRule.DefaultError).LevelOfImage(camera.Footprint, subsamplesPerAxis: 1);
        Assert.Equal(1, level);

        double[] truth = Draw(map, 8);
        double ofMap = Rms(truth, Draw(map, 1));
        double ofLevel = Rms(truth, Draw(levels.Grid(level), 1));
        Assert.InRange(ofLevel, 0.2 * ofMap, 1.05 * ofMap);

        double[] Draw(ITerrainGrid grid, int subsamplesPerAxis)
        {
            NativeRenderOptions options = new()
            {
                Reflectance = new LambertReflectance(0.64),
                SubsamplesPerAxis = subsamplesPerAxis,
            };
            using NativeFrame frame = new NativeRenderer(grid).Render(camera, sun, options, threads: 2);
            return frame.RadianceFactors.ToArray();
        }
    }

    private static double Rms(double[] expected, double[] found) =>
        Math.Sqrt(expected.Zip(found, (one, other) => (one - other) * (one - other)).Average());
}
