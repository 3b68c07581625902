using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Render;

public sealed class TruthRowTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private const int Width = 90;

    private const int Height = 60;

    [Theory]
    [InlineData("limb", NormalModel.Facet, SunModel.Point)]
    [InlineData("limb", NormalModel.Smooth, SunModel.Point)]
    [InlineData("oblique-20km", NormalModel.Facet, SunModel.Disc)]
    public void ReadRow_OfADrawnFrame_HasTheBitsOfTheSinglePixels(string name, NormalModel normals, SunModel sun)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        NativeRenderOptions options = new()
        {
            Reflectance = new LambertReflectance(0.64),
            Normals = normals,
            Sun = sun,
            KeepGroundTruth = true,
        };
        using NativeFrame frame = new NativeRenderer(rugged.Grid).Render(
            scene.Camera(rugged.Grid, Width, Height), new SceneLight(scene.Sun, IsSun: true), options, threads: 1);
        TruthRow row = new();
        int seen = 0;
        for (int y = 1; y <= Height; y++)
        {
            ((IGroundTruth)frame).ReadRow(y, row);
            int next = 0;
            for (int x = 1; x <= Width; x++)
            {
                if (frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
                {
                    Assert.Equal((x - 1, hit, light), At(row, next++));
                }
            }

            Assert.Equal(next, row.Points.Count);
            seen += next;
        }

        Assert.InRange(seen, 500, Width * Height);
    }

    [Theory]
    [InlineData(3, 4, new[] { 0, 2 })]
    [InlineData(0, 10, new[] { 1, 3, 5, 8 })]
    [InlineData(6, 2, new int[0])]
    public void Cut_PartOfTheColumns_LeavesTheirPixelsCountedFromTheFirst(int firstColumn, int width, int[] expected)
    {
        TruthRow row = new();
        row.Clear(10);
        foreach (int column in new[] { 1, 3, 5, 8 })
        {
            row.Add(
                column,
                new SurfaceHit(new Vector3D(column, 2.0, 3.0), Vector3D.UnitZ, new FacetId(column, 0, FacetHalf.SouthWest), 0.5 * column),
                new PixelIllumination(IlluminationState.Penumbra, 0.1 * column));
        }

        row.Cut(firstColumn, width);

        Assert.Equal(expected.Length, row.Points.Count);
        for (int i = 0; i < expected.Length; i++)
        {
            (int column, SurfaceHit hit, PixelIllumination light) = At(row, i);
            int whole = expected[i] + firstColumn;
            Assert.Equal((expected[i], whole, 0.5 * whole), (column, hit.Facet.Line, hit.RayParameter));
            Assert.Equal((whole, 0.1 * whole), (hit.PointBodyFixed.X, light.VisibleFraction));
        }
    }

    private static (int Column, SurfaceHit Hit, PixelIllumination Light) At(TruthRow row, int i) => (
        row.Points.Columns[i],
        new SurfaceHit(
            new Vector3D(row.Points.X[i], row.Points.Y[i], row.Points.Z[i]),
            new Vector3D(row.Points.NormalX[i], row.Points.NormalY[i], row.Points.NormalZ[i]),
            row.Facets[i],
            row.Points.Parameters[i]),
        row.Lights[i]);
}
