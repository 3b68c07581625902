using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Render;

public class TracedFrameTruthTests
{
    private const double SunDistance = 1.5e11;
    private static readonly Vector3D Ground = new(1_738_000.0, 0.0, 0.0);

    /// <summary>Over the ground point, looking straight down; north is up.</summary>
    private static readonly PinholeCamera Camera = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity, 0.7, 3, 3);

    /// <summary>A facet that leans 30 degrees to the north.</summary>
    private static readonly SurfaceHit Slope = new(
        Ground, new Vector3D(Math.Sqrt(0.75), 0.0, 0.5), new FacetId(359, 0, FacetHalf.NorthEast), 0.25);

    [Theory]
    [InlineData(60.0, false, IlluminationState.Lit)]
    [InlineData(60.0, true, IlluminationState.Shadow)]
    [InlineData(-45.0, false, IlluminationState.Lit)]
    [InlineData(-75.0, false, IlluminationState.Shadow)] // above the horizon; the facet turns away
    [InlineData(-95.0, false, IlluminationState.Night)]
    [InlineData(-95.0, true, IlluminationState.Night)]
    [InlineData(100.0, false, IlluminationState.Lit)] // below the horizon of the sphere; the facet still sees it
    [InlineData(100.0, true, IlluminationState.Night)]
    public void TryGet_SunNorthOfTheZenith_HasTheStateOfItsHeight(double degreesFromZenith, bool isHidden, IlluminationState expected)
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(degreesFromZenith));
        SceneLight sun = new(SunDistance * new Vector3D(cosine, 0.0, sine), IsSun: true);
        TracedFrameTruth truth = new(Camera, sun, new FakeTracer(Slope, isHidden));

        Assert.True(truth.TryGet(2, 2, out SurfaceHit hit, out PixelIllumination light));

        Assert.Equal(Slope, hit);
        Assert.Equal(new PixelIllumination(expected, expected == IlluminationState.Lit ? 1.0 : 0.0), light);
        Assert.Equal(sun.PositionBodyFixed, truth.Light.PositionBodyFixed);
    }

    [Fact]
    public void TryGet_LampAtTheCamera_LightsAllThatIsSeen()
    {
        SurfaceHit turnedAway = Slope with { NormalBodyFixed = -Slope.NormalBodyFixed };
        TracedFrameTruth truth = new(
            Camera, new SceneLight(Camera.PositionBodyFixed, IsSun: false), new FakeTracer(turnedAway, isHidden: true));

        Assert.True(truth.TryGet(2, 2, out _, out PixelIllumination light));

        Assert.Equal(new PixelIllumination(IlluminationState.Lit, 1.0), light);
    }

    [Fact]
    public void TryGet_Space_HasNeitherHitNorLight()
    {
        TracedFrameTruth truth = new(
            Camera, new SceneLight(SunDistance * Vector3D.UnitX, IsSun: true), new FakeTracer(null, isHidden: false));

        Assert.False(truth.TryGet(1, 1, out SurfaceHit hit, out PixelIllumination light));

        Assert.Equal(default, hit);
        Assert.Equal(IlluminationState.NoSurface, light.State);
    }

    [Fact]
    public void TryGet_Pixel_TracesTheRayThroughItsCentre()
    {
        FakeTracer tracer = new(Slope, isHidden: false);
        TracedFrameTruth truth = new(Camera, new SceneLight(SunDistance * Vector3D.UnitX, IsSun: true), tracer);

        truth.TryGet(3, 1, out _, out _);

        Assert.Equal(Camera.RayThrough(3, 1), tracer.Traced);
        Assert.Equal((Slope.PointBodyFixed, Slope.Facet, truth.Light.PositionBodyFixed), tracer.Asked);
    }

    private sealed class FakeTracer(SurfaceHit? seen, bool isHidden) : ITerrainTracer
    {
        public double MaxRadius => throw new NotSupportedException();

        public Ray Traced { get; private set; }

        public (Vector3D Point, FacetId Facet, Vector3D Light) Asked { get; private set; }

        public bool TryTrace(Ray ray, out SurfaceHit hit)
        {
            Traced = ray;
            hit = seen ?? default;
            return seen is not null;
        }

        public bool IsHidden(Vector3D pointBodyFixed, FacetId facet, Vector3D lightBodyFixed)
        {
            Asked = (pointBodyFixed, facet, lightBodyFixed);
            return isHidden || Vector3D.Dot(seen!.Value.NormalBodyFixed, lightBodyFixed - pointBodyFixed) <= 0.0;
        }
    }
}
