using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>A pixel's radiance is that of the law, at the angles that the meta file and the layers give for it.</summary>
public sealed class NativeRendererShadingTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    /// <summary>1, part of the radiance factor: angles near 0 and 90 degrees turn 16 digits into 10.</summary>
    private const double SameRadiance = 1e-9;

    private static readonly Dictionary<string, double> NoParameters = [];

    private readonly NativeRenderer _renderer = new(rugged.Grid);

    [Theory]
    [InlineData("lambert", NormalModel.Facet)]
    [InlineData("lambert", NormalModel.Smooth)]
    [InlineData("lommel-seeliger", NormalModel.Facet)]
    [InlineData("lommel-seeliger", NormalModel.Smooth)]
    [InlineData("lunar-lambert", NormalModel.Facet)]
    [InlineData("hapke", NormalModel.Facet)]
    [InlineData("hapke", NormalModel.Smooth)]
    public void Render_Law_IsThatOfThePixelsAngles(string name, NormalModel normals)
    {
        IReflectance law = ReflectanceFactory.Create(name, NoParameters);
        int lit = 0;
        foreach (string scene in new[] { "oblique-20km", "limb", "wide-angle" })
        {
            using NativeFrame frame = Draw(scene, law, normals);
            for (int pixel = 0; pixel < frame.RadianceFactors.Length; pixel++)
            {
                (int x, int y) = ((pixel % frame.Camera.Width) + 1, (pixel / frame.Camera.Width) + 1);
                double expected = frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light)
                    && light.State == IlluminationState.Lit
                    ? RadianceFactor(
                        law,
                        PhotometricAngles.At(hit.PointBodyFixed, hit.NormalBodyFixed, frame.Camera.PositionBodyFixed,
                            frame.Light.PositionBodyFixed))
                    : 0.0;
                Assert.True(
                    Math.Abs(frame.RadianceFactors[pixel] - expected) <= SameRadiance,
                    $"{scene} ({x}, {y}): {frame.RadianceFactors[pixel]}, the law says {expected}");
                lit += expected > 0.0 ? 1 : 0;
            }
        }

        Assert.InRange(lit, 2000, 14_000);
    }

    [Fact]
    public void Render_Smooth_KeepsFacetsDarkThatTurnAway()
    {
        IReflectance law = new LambertReflectance(0.64);
        using NativeFrame facets = Draw("oblique-20km", law, NormalModel.Facet);
        using NativeFrame smooth = Draw("oblique-20km", law, NormalModel.Smooth);
        int keptDark = 0;
        int changed = 0;
        for (int pixel = 0; pixel < facets.RadianceFactors.Length; pixel++)
        {
            (int x, int y) = ((pixel % facets.Camera.Width) + 1, (pixel / facets.Camera.Width) + 1);
            if (!facets.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
            {
                continue;
            }

            smooth.TryGet(x, y, out SurfaceHit smoothHit, out PixelIllumination smoothLight);
            Assert.Equal((hit.Facet, hit.PointBodyFixed, light), (smoothHit.Facet, smoothHit.PointBodyFixed, smoothLight));
            changed += facets.RadianceFactors[pixel] != smooth.RadianceFactors[pixel] ? 1 : 0;
            if (light.State != IlluminationState.Lit)
            {
                Assert.Equal(0.0, smooth.RadianceFactors[pixel]);
                bool turnsAway = Vector3D.Dot(hit.NormalBodyFixed, facets.Light.PositionBodyFixed - hit.PointBodyFixed) < 0.0;
                bool smoothFaces = Vector3D.Dot(smoothHit.NormalBodyFixed, facets.Light.PositionBodyFixed - hit.PointBodyFixed) > 0.0;
                keptDark += turnsAway && smoothFaces ? 1 : 0;
            }
        }

        Assert.True(keptDark > 20 && changed > 500, $"{keptDark} pixels of facets that turn away, {changed} that differ, say little");
    }

    /// <summary>
    /// At the limb some normals between samples look away from the camera; a law that asks for the viewer would leave black specks.
    /// </summary>
    [Fact]
    public void Render_SmoothNormalLooksAway_IsShadedByItsFacet()
    {
        IReflectance law = ReflectanceFactory.Create("lommel-seeliger", NoParameters);
        using NativeFrame facets = Draw("limb", law, NormalModel.Facet);
        using NativeFrame smooth = Draw("limb", law, NormalModel.Smooth);
        int facetsOwn = 0;
        for (int pixel = 0; pixel < smooth.RadianceFactors.Length; pixel++)
        {
            (int x, int y) = ((pixel % smooth.Camera.Width) + 1, (pixel / smooth.Camera.Width) + 1);
            if (smooth.TryGet(x, y, out SurfaceHit hit, out _))
            {
                facets.TryGet(x, y, out SurfaceHit facetHit, out _);
                Assert.True(Vector3D.Dot(hit.NormalBodyFixed, smooth.Camera.PositionBodyFixed - hit.PointBodyFixed) > 0.0,
                    $"({x}, {y}): {hit}");
                bool isFacetsOwn = hit.NormalBodyFixed == facetHit.NormalBodyFixed;
                Assert.True(!isFacetsOwn || smooth.RadianceFactors[pixel] == facets.RadianceFactors[pixel], $"({x}, {y}): {hit}");
                facetsOwn += isFacetsOwn && smooth.RadianceFactors[pixel] > 0.0 ? 1 : 0;
            }
        }

        Assert.InRange(facetsOwn, 1, 200);
    }

    /// <summary>Without truth the image lies where the cosines of the light lay.</summary>
    [Theory]
    [InlineData("lambert", NormalModel.Facet, SunModel.Point)]
    [InlineData("lambert", NormalModel.Smooth, SunModel.Point)]
    [InlineData("lambert", NormalModel.Facet, SunModel.Disc)]
    [InlineData("lommel-seeliger", NormalModel.Facet, SunModel.Point)]
    [InlineData("hapke", NormalModel.Smooth, SunModel.Disc)]
    public void Render_WithoutTruth_IsTheSameToTheBit(string name, NormalModel normals, SunModel sun)
    {
        IReflectance law = ReflectanceFactory.Create(name, NoParameters);
        foreach (string scene in new[] { "oblique-20km", "limb", "wide-angle" })
        {
            FrameValues expected = Values(Draw(scene, law, normals, sun));
            using (NativeFrame plain = Draw(scene, law, normals, sun, keepsTruth: false))
            {
                Assert.Equal(expected.RadianceFactors, plain.RadianceFactors.ToArray().Select(BitConverter.DoubleToInt64Bits));
            }

            Assert.Equal(expected, Values(Draw(scene, law, normals, sun))); // its light needs memory of its own again
        }
    }

    private static FrameValues Values(NativeFrame drawn)
    {
        using NativeFrame frame = drawn;
        return FrameValues.Of(frame);
    }

    private static double RadianceFactor(IReflectance law, PhotometricAngles angles)
    {
        double cosIncidence = Math.Cos(angles.Incidence);
        double cosEmission = Math.Cos(angles.Emission);
        double sineOfHalf = Math.Sin(angles.Phase / 2.0);
        return cosIncidence > 0.0 && (cosEmission > 0.0 || !law.DependsOnViewer)
            ? law.RadianceFactor(cosIncidence, cosEmission, sineOfHalf * sineOfHalf)
            : 0.0;
    }

    private NativeFrame Draw(
        string name, IReflectance law, NormalModel normals, SunModel sun = SunModel.Point, bool keepsTruth = true)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        PinholeCamera camera = scene.Camera(rugged.Grid, 90, 60);
        NativeRenderOptions options = new() { Reflectance = law, Normals = normals, Sun = sun, KeepGroundTruth = keepsTruth };
        return _renderer.Render(camera, new SceneLight(scene.Sun, IsSun: true), options, threads: 2);
    }
}
