using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Render.Photometry;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shading;

/// <summary>Pixels are shaded early, as their rows are read for the shadows, or late, when the shadows are known.</summary>
public sealed class RowReflectionTests
{
    private const int Side = 60;

    private static readonly AlbedoMap Map = SyntheticMaps.Of(720, (column, row) => 1000 + ((37 * column) % 500) + ((91 * row) % 700));

    [Theory]
    [InlineData("nadir-100km", true, true)] // all ground faces the Sun
    [InlineData("half-sky", false, true)]
    [InlineData("grazing-sun", false, true)]
    [InlineData("grazing-sun", false, false)]
    public void FindFactors_EarlyAndLate_AreTheSame(string scene, bool facesAll, bool hasMap)
    {
        NativeRenderOptions options = new()
        {
            Reflectance = ReflectanceFactory.Create("moon", new Dictionary<string, double>()),
            Albedo = hasMap ? Map : null,
        };
        IGlobalGrid grid = FunctionGrid.Rugged(4);
        RenderScenes.RenderSceneCase given = RenderScenes.Named(scene);
        PinholeCamera camera = given.Camera(grid, Side, Side);
        SurfaceModel surface = new(grid);
        VisibleSurface visible = new VisibilityPass(surface).Run(camera, threads: 1, CancellationToken.None);
        SceneLight light = new(given.Sun, IsSun: true);
        PixelSunlight sunlight = new();
        sunlight.Prepare(Side * Side, hasFractions: false); // nothing is hidden
        Dictionary<int, double[]> early = [];
        HashSet<bool> isShared = [];
        RowReflection reflection = new(surface);
        SunwardPoints points = new(visible, given.Sun, sunlight.CosIncidence)
        {
            RowRead = (row, pixels, cosines) =>
            {
                reflection.TakeFacing(pixels, cosines, Side);
                reflection.FindFactors(camera, light, options);
                isShared.Add(reflection.Points.Count > 0 && ReferenceEquals(reflection.Points.X, pixels.X));
                double[] factors = new double[Side];
                for (int i = 0; i < reflection.Points.Count; i++)
                {
                    factors[reflection.Points.Columns[i]] = reflection.Points.Factors[i];
                }

                early.Add(row, factors);
            },
        };
        for (int row = 0; row < Side; row++)
        {
            points.ReadCosines(row);
        }

        RowReflection late = new(surface);
        int lit = 0;
        for (int row = 0; row < Side; row++)
        {
            late.TakeLit(visible, row, light, sunlight, NormalModel.Facet);
            late.FindFactors(camera, light, options);
            for (int i = 0; i < late.Points.Count; i++)
            {
                Assert.Equal(late.Points.Factors[i], early[row][late.Points.Columns[i]]);
            }

            lit += late.Points.Count;
        }

        Assert.Contains(facesAll, isShared);
        Assert.InRange(lit, 50, Side * Side);
    }
}
