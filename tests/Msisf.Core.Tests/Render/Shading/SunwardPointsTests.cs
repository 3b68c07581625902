using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shading;

public sealed class SunwardPointsTests
{
    private const int Side = 60;

    [Theory]
    [InlineData("oblique-20km", 0.0)]
    [InlineData("half-sky", 0.0)]
    [InlineData("grazing-sun", -0.005)]
    public void Read_AllRowsAndSomeAgain_GivesThePointsAndCosinesOfThePlainFormula(string scene, double minCosine)
    {
        IGlobalGrid grid = FunctionGrid.Rugged(4);
        RenderScenes.RenderSceneCase given = RenderScenes.Named(scene);
        PinholeCamera camera = given.Camera(grid, Side, Side);
        VisibleSurface visible = new VisibilityPass(new SurfaceModel(grid)).Run(camera, threads: 1, CancellationToken.None);
        double[] cosines = new double[Side * Side];
        SunwardPoints points = new(visible, given.Sun, cosines, minCosine);
        double[] x = new double[Side];
        double[] y = new double[Side];
        double[] z = new double[Side];
        int[] columns = new int[Side];
        int sunward = 0;
        for (int row = 0; row < Side; row++)
        {
            Dictionary<int, Vector3D> found = [];
            int count = points.Read(row, x, y, z, columns);
            for (int i = 0; i < count; i++)
            {
                found.Add(columns[i], new Vector3D(x[i], y[i], z[i]));
            }

            for (int column = 0; column < Side; column++)
            {
                bool isSurface = visible.TryGet(column + 1, row + 1, out SurfaceHit hit);
                Vector3D toSun = given.Sun - hit.PointBodyFixed;
                double cosine = isSurface
                    ? Math.Min(Vector3D.Dot(hit.NormalBodyFixed, toSun) / Math.Sqrt(toSun.LengthSquared), 1.0)
                    : -1.0;
                Assert.Equal(cosine, cosines[(row * Side) + column]);
                Assert.Equal(cosine > minCosine, found.TryGetValue(column, out Vector3D point));
                Assert.True(cosine <= minCosine || point == hit.PointBodyFixed, $"{column}, {row}");
            }

            double[] again = new double[Side];
            int[] some = [.. columns[..count].Where(column => column % 3 != 1)];
            points.ReadAgain(row, some, again, y, z);
            for (int i = 0; i < some.Length; i++)
            {
                Assert.Equal(found[some[i]], new Vector3D(again[i], y[i], z[i]));
            }

            sunward += count;
        }

        Assert.InRange(sunward, 50, (Side * Side) - 1);
    }
}
