using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Sampling;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Sampling;

/// <summary>The brightness of pixels by the areas of their facets.</summary>
public sealed class FacetAreasTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private const int Side = 90;

    [Theory]
    [InlineData(0.0, 1.0, 0.0, 0.5)] // through the centre, along the rows or columns
    [InlineData(0.0, 1.0, 1.0, 0.5)]
    [InlineData(0.25, 0.0, 1.0, 0.25)]
    [InlineData(0.5, 1.0, 0.0, 0.0)] // on the border of the pixel
    [InlineData(0.5, 1.0, 1.0, 0.125)] // through the middles of two sides
    [InlineData(0.75, 2.0, 1.0, 0.140625)] // a corner: sides of 0.375 and 0.75 px
    [InlineData(1.0, 1.0, 1.0, 0.0)] // through a corner
    [InlineData(9.0, 1.0, 2.0, 0.0)]
    [InlineData(0.0, 0.0, 0.0, 0.0)] // two facets in one plane
    public void PartBeyond_ALine_IsTheAreaBeyondIt(double atCentre, double perColumn, double perRow, double expected) =>
        Assert.Equal(expected, PartBeyond(atCentre, perColumn, perRow), Rounding.OfUnits);

    [Fact]
    public void PartBeyond_RandomLines_AreThePartsOfManyPoints()
    {
        const int Points = 400;
        Random random = new(5);
        for (int line = 0; line < 40; line++)
        {
            (double atCentre, double perColumn, double perRow) = (random.NextDouble(), random.NextDouble(), random.NextDouble());
            int beyond = 0;
            for (int point = 0; point < Points * Points; point++)
            {
                double x = (((point % Points) + 0.5) / Points) - 0.5;
                double y = (((point / Points) + 0.5) / Points) - 0.5;
                beyond += (perColumn * x) + (perRow * y) > atCentre ? 1 : 0;
            }

            Assert.Equal(beyond / (double)(Points * Points), PartBeyond(atCentre, perColumn, perRow), 1.0 / Points);
        }
    }

    /// <summary>Facets of several pixels: what one line crosses is as bright as 64 samples say, and far from what one says.</summary>
    [Fact]
    public void Look_LargeFacets_MeansComeNearSixtyFourSamples()
    {
        (PinholeCamera camera, SceneLight light) = Scene("nadir-100km", Side);
        (FacetsAround[] kinds, double[] means) = Look(camera, light);
        double[] one = Factors(camera, light, 1);
        double[] truth = Factors(camera, light, 8);

        int changed = 0;
        double ofMeans = 0.0;
        double ofCentres = 0.0;
        for (int pixel = 0; pixel < one.Length; pixel++)
        {
            if (kinds[pixel] == FacetsAround.OneLine && means[pixel] != one[pixel])
            {
                changed++;
                ofMeans += Math.Pow(means[pixel] - truth[pixel], 2.0);
                ofCentres += Math.Pow(one[pixel] - truth[pixel], 2.0);
            }
        }

        Assert.InRange(changed, Side * Side / 50, Side * Side);
        Assert.True(ofMeans < 0.25 * ofCentres, $"{Math.Sqrt(ofMeans / changed)} and {Math.Sqrt(ofCentres / changed)}");
    }

    /// <summary>At the limb a facet ends where no plane of a neighbour says so.</summary>
    [Fact]
    public void Look_TheLimb_PixelsBesideTheSkyAreOther()
    {
        (PinholeCamera camera, SceneLight light) = Scene("limb", Side);
        (FacetsAround[] kinds, double[] means) = Look(camera, light);
        VisibleSurface visible = new VisibilityPass(new(rugged.Grid)).Run(camera, 2, CancellationToken.None);

        int checkedPixels = 0;
        double[] one = Factors(camera, light, 1);
        for (int pixel = 0; pixel < kinds.Length - Side; pixel++)
        {
            bool isSurface = visible.TryGet((pixel % Side) + 1, (pixel / Side) + 1, out _);
            if (isSurface != visible.TryGet((pixel % Side) + 1, (pixel / Side) + 2, out _))
            {
                Assert.Equal(FacetsAround.Other, kinds[isSurface ? pixel : pixel + Side]);
                Assert.Equal(one[pixel], means[pixel]);
                checkedPixels++;
            }
        }

        Assert.InRange(checkedPixels, Side / 2, Side * Side);
    }

    /// <summary>
    /// Ridges before farther ground: there the planes do not meet between the pixels, though no sky is near and a neighbour is on the same
    /// facet.
    /// </summary>
    [Fact]
    public void Look_ARidgeBeforeFartherGround_IsOther()
    {
        (PinholeCamera camera, SceneLight light) = Scene("along-parallel", Side);
        (FacetsAround[] kinds, _) = Look(camera, light);
        VisibleSurface visible = new VisibilityPass(new(rugged.Grid)).Run(camera, 2, CancellationToken.None);

        int ridges = 0;
        for (int pixel = Side; pixel < kinds.Length; pixel++)
        {
            if (visible.TryGet((pixel % Side) + 1, (pixel / Side) + 1, out SurfaceHit near)
                && visible.TryGet((pixel % Side) + 1, pixel / Side, out SurfaceHit above)
                && Math.Abs(above.Facet.Sample - near.Facet.Sample) > 5)
            {
                Assert.Equal(FacetsAround.Other, kinds[pixel]);
                ridges++;
            }
        }

        Assert.InRange(ridges, 3, kinds.Length);
    }

    private static double PartBeyond(double atCentre, double perColumn, double perRow) =>
        FacetAreas.PartBeyond(Vector256.Create(atCentre), Vector256.Create(perColumn), Vector256.Create(perRow))[3];

    /// <summary>Looks at all rows, each with a contrast of 1.</summary>
    private (FacetsAround[] Kinds, double[] Means) Look(PinholeCamera camera, SceneLight light)
    {
        VisibleSurface visible = new VisibilityPass(new(rugged.Grid)).Run(camera, 2, CancellationToken.None);
        double[] factors = Factors(camera, light, 1);
        byte[] contrasts = new byte[camera.Width];
        Array.Fill(contrasts, (byte)1);
        FacetAreas areas = new();
        List<FacetsAround> kinds = [];
        double[] means = new double[factors.Length];
        for (int row = 0; row < camera.Height; row++)
        {
            areas.Look(
                visible, row, isFirst: row % 7 == 0, contrasts, minContrast: 1, factors, means.AsSpan(row * camera.Width, camera.Width));
            kinds.AddRange(areas.Kinds[..camera.Width]);
        }

        return ([.. kinds], means);
    }

    private double[] Factors(PinholeCamera camera, SceneLight light, int subsamplesPerAxis)
    {
        NativeRenderOptions options = new() { Reflectance = new LambertReflectance(0.64), SubsamplesPerAxis = subsamplesPerAxis };
        using NativeFrame frame = new NativeRenderer(rugged.Grid).Render(camera, light, options, threads: 2);
        return [.. frame.RadianceFactors.ToArray()];
    }

    private (PinholeCamera Camera, SceneLight Light) Scene(string name, int side)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        return (scene.Camera(rugged.Grid, side, side), new SceneLight(scene.Sun, IsSun: true));
    }
}
