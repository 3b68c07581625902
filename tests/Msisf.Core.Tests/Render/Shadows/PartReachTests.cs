using System.Numerics;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>A part within reach has all its samples within a bin of its mean, none deeper than the point that stands for it.</summary>
public sealed class PartReachTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private const int Side = 40;

    /// <summary>m: mean and sample are computed apart, rounding by some 1e-9 m; a bin's depth is rounded up by 0.03 m or more.</summary>
    private const double Rounding = 1e-6;

    public static TheoryData<string> Scenes => [.. RenderScenes.Names];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Reach_APartThatIsNotMarked_HoldsItsSamples(string name)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        FrameCamera camera = scene.Camera(rugged.Grid, Side, Side);
        SurfaceModel surface = new(rugged.Grid);
        VisibilityPass pass = new(surface);
        pass.Prepare(camera, 1, CancellationToken.None);
        SampledPixels pixels = new();
        SamplePattern pattern = SamplePattern.OfGrid(4);
        pixels.TakeAll(Side, Side, pattern);
        (PixelParts parts, PixelParts samples) = (new PixelParts(), new PixelParts());
        new SubsampleWorker().Draw(surface, pass, pixels, pixels.Bands[0], parts);
        samples.TakeSamples(
            parts, Enumerable.Repeat(ShadowPass.Unsure, parts.Count).ToArray(), ShadowPass.Unsure, pattern, pass.View);
        LightFrame frame = new(scene.Sun, camera.PositionMoonMe);
        Vector3D[] means = [.. Points(parts, pass.View).Select(point => frame.FromMoonMe(point))];
        Vector3D[] all = [.. Points(samples, pass.View).Select(point => frame.FromMoonMe(point))];
        LightBox box = means.Aggregate(LightBox.Empty, (sum, p) => LightBox.Union(sum, new LightBox(p.X, p.X, p.Y, p.Y)));
        ReceiverGrid grid = new();
        grid.Lay(box, means.Length, 1, means.Length);
        PartReach reach = new(pass.View, frame, grid);
        byte[] states = new byte[parts.Count];
        Vector3D[] deepest = [.. Points(parts, pass.View, (row, first) => reach.Reach(
            row, parts.Reaches.AsSpan(first, row.Count), states.AsSpan(first), ShadowPass.Unsure)).Select(p => frame.FromMoonMe(p))];

        int first = 0;
        for (int part = 0; part < parts.Count; part++)
        {
            int count = BitOperations.PopCount(parts.Samples[part]);
            foreach (Vector3D sample in states[part] == 0 ? all.AsSpan(first, count) : [])
            {
                Assert.InRange(Math.Abs(sample.X - means[part].X), 0.0, reach.U);
                Assert.InRange(Math.Abs(sample.Y - means[part].Y), 0.0, reach.V);
                Assert.InRange(sample.Z, double.NegativeInfinity, deepest[part].Z + Rounding);
            }

            first += count;
        }

        Assert.Equal(first, all.Length);
    }

    private static List<Vector3D> Points(PixelParts parts, ImageView view, Action<SurfaceRow, int>? change = null)
    {
        PartRows rows = new();
        rows.Begin(view);
        rows.Add(parts);
        SurfaceRow row = new();
        List<Vector3D> points = [];
        for (int y = 1; y <= rows.Height; y++)
        {
            rows.Read(y, row);
            change?.Invoke(row, (y - 1) * PartRows.RowLength);
            points.AddRange(Enumerable.Range(0, row.Count).Select(i => new Vector3D(row.X[i], row.Y[i], row.Z[i])));
        }

        return points;
    }
}
