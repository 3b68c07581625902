using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>The further samples of a pixel show what images show whose pixel centres are shifted there.</summary>
public sealed class SubsampleWorkerTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    /// <summary>m per m of the camera's distance: a sample's depth comes from the projected corners, then from the facet's plane.</summary>
    private const double SamePoint = 1e-12;

    /// <summary>Samples on an edge between two facets, where rounding decides.</summary>
    private const int OnEdges = 2;

    /// <summary>8 or all 64 samples of a pixel.</summary>
    private static readonly int Vectors = TestLength.Of(1, SamplePattern.StratifiedVectors);

    public static TheoryData<string> Scenes => [.. RenderScenes.Names];

    public static TheoryData<string> Lenses => [.. LensCases.Names];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Draw_ASceneOfAPinhole_ShowsWhatShiftedImagesShow(string name)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        Compare(scene.Camera(rugged.Grid, 30, 41));
    }

    [Theory]
    [MemberData(nameof(Lenses))]
    public void Draw_ASceneOfALens_ShowsWhatShiftedImagesShow(string name)
    {
        PinholeCamera pinhole = RenderScenes.Named("oblique-20km").Camera(rugged.Grid, 30, 41);
        Compare(LensCases.Of(name, 0.4, 41, 30).At(pinhole.State));
    }

    [Fact]
    public void Take_SamplesOnOneFacet_AreOnePartAtTheirMean()
    {
        PinholeCamera camera = RenderScenes.Named("nadir-100km").Camera(rugged.Grid, 20, 20);
        (List<(int Pixel, FacetId Facet, Vector3D Point, double Weight)> split, _) = Parts(camera, isSplit: true);
        (List<(int Pixel, FacetId Facet, Vector3D Point, double Weight)> joined, _) = Parts(camera, isSplit: false);

        var expected = split.GroupBy(part => (part.Pixel, part.Facet)).ToDictionary(
            group => group.Key, group => (Weight: group.Sum(part => part.Weight), Points: group.Select(part => part.Point).ToArray()));
        Assert.Equal(expected.Count, joined.Count);
        Assert.True(joined.Count < split.Count);
        Assert.All(joined, part =>
        {
            (double weight, Vector3D[] points) = expected[(part.Pixel, part.Facet)];
            Vector3D mean = points.Aggregate(default(Vector3D), (sum, point) => sum + point) / points.Length;
            Assert.Equal(weight, part.Weight, Rounding.OfChains);
            Assert.InRange((part.Point - mean).Length, 0.0, 5.0); // a pixel is 3.6 km wide; perspective moves the mean a little
        });
    }

    private void Compare(FrameCamera camera)
    {
        (List<(int Pixel, FacetId Facet, Vector3D Point, double Weight)> parts, ImageView view) = Parts(camera, isSplit: true);
        Dictionary<(int, FacetId), List<Vector3D>> points = [];
        int expected = 0;
        VisibilityPass pass = new(new SurfaceModel(rugged.Grid));
        for (int sample = 0; sample < Vectors * SamplePattern.Lanes; sample++)
        {
            FrameCamera there = ShiftedCamera.Of(
                camera, SamplePattern.Stratified.Right[sample], SamplePattern.Stratified.Down[sample]);
            VisibleSurface shifted = pass.Run(there, 2, CancellationToken.None);
            for (int pixel = 0; pixel < camera.Width * camera.Height; pixel++)
            {
                if (shifted.TryGet((pixel % camera.Width) + 1, (pixel / camera.Width) + 1, out SurfaceHit hit))
                {
                    expected++;
                    if (!points.TryGetValue((pixel, hit.Facet), out List<Vector3D>? list))
                    {
                        points[(pixel, hit.Facet)] = list = [];
                    }

                    list.Add(hit.PointBodyFixed);
                }
            }
        }

        double tolerance = SamePoint * view.Camera.PositionBodyFixed.Length;
        int found = parts.Count(part => points.TryGetValue((part.Pixel, part.Facet), out List<Vector3D>? list)
            && list.Exists(point => (point - part.Point).Length <= Math.Max(tolerance, 1e-5)));
        Assert.InRange(expected, 100, int.MaxValue);
        Assert.InRange(parts.Count, expected - OnEdges, expected + OnEdges);
        Assert.InRange(found, expected - OnEdges, expected);
    }

    private (List<(int Pixel, FacetId Facet, Vector3D Point, double Weight)> Parts, ImageView View) Parts(
        FrameCamera camera, bool isSplit)
    {
        SurfaceModel surface = new(rugged.Grid);
        VisibilityPass pass = new(surface);
        pass.Run(camera, 2, CancellationToken.None);
        SampledPixels pixels = new();
        pixels.Prepare(SamplePattern.Stratified, camera.Width, camera.Height);
        Array.Fill(pixels.Codes, (byte)(Vectors | (isSplit ? SampledPixels.HasBorder : 0)));
        SubsampleWorker worker = new();
        List<(int, FacetId, Vector3D, double)> found = [];
        Array.Fill(pixels.VectorsOfRow, Vectors * camera.Width);
        pixels.Cut();
        foreach (SampledBand band in pixels.Bands)
        {
            PixelParts parts = new();
            worker.Draw(surface, pass, pixels, band, parts);
            PartRows partRows = new();
            partRows.Begin(pass.View);
            partRows.Add(parts, isSplit ? parts.Receivers : parts.Points);
            int[] partOf = [.. parts.ReceiverEnds.Take(parts.Count).SelectMany((end, part) =>
                Enumerable.Repeat(part, end - (part == 0 ? 0 : parts.ReceiverEnds[part - 1])))];
            SurfaceRow row = new();
            for (int y = 1; y <= partRows.Height; y++)
            {
                partRows.Read(y, row);
                for (int i = 0; i < row.Count; i++)
                {
                    int point = ((y - 1) * PartRows.RowLength) + i;
                    int part = isSplit ? partOf[point] : point;
                    found.Add((
                        parts.Pixels[part], partRows.FacetOf(y, row.Facets[i]), new Vector3D(row.X[i], row.Y[i], row.Z[i]),
                        isSplit ? 1.0 / (Vectors * SamplePattern.Lanes) : parts.Weights[part]));
                }
            }
        }

        return (found, pass.View);
    }
}
