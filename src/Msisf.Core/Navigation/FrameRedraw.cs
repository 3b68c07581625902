using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Sensitivity;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Navigation;

/// <summary>Draws a frame again with other lights, on the surface that it shows.</summary>
/// <param name="camera">What was drawn: the frame's camera with a margin.</param>
/// <param name="margin">px.</param>
/// <param name="options">The frame's; one sample, facets and no map are enough.</param>
public sealed class FrameRedraw(NativeRenderer renderer, ICamera camera, int margin, NativeRenderOptions options)
{
    private readonly Lazy<SurfaceModel> _surface = new(() => SurfaceModel.Of(renderer.Terrain));

    /// <summary>The surface.</summary>
    public ITerrain Terrain => renderer.Terrain;

    /// <summary>px: how much more is drawn at each side.</summary>
    public int Margin => margin;

    /// <summary>Whether the frame's Sun is a disc.</summary>
    public SunModel Sun => options.Sun;

    /// <summary>Draws the frame.</summary>
    /// <param name="sun">Whether it is a point or the Sun's disc.</param>
    public NativeFrame With(SceneLight light, SunModel sun, int threads, CancellationToken cancellation) => renderer.Render(
        camera,
        light,
        options with
        {
            Sun = sun,
            Normals = NormalModel.Facet,
            SubsamplesPerAxis = 1,
            Adaptive = null,
            Albedo = null,
            Hapke = null,
            KeepGroundTruth = true,
        },
        threads,
        cancellation);

    /// <summary>The derivatives of the radiance factors of what was drawn.</summary>
    /// <param name="light">The Sun.</param>
    public SensitivityField Sensitivities(SceneLight light, int threads, CancellationToken cancellation) =>
        new SensitivityFinder(renderer, new TerrainTracer(renderer.Terrain), options)
            .Find((FrameCamera)camera, light, threads, cancellation);

    /// <summary>The outward normal of a facet, body-fixed, of any length.</summary>
    internal Vector3D NormalOf(FacetId facet)
    {
        (Vector3D a, Vector3D b, Vector3D c) = _surface.Value.CornersOf(facet);
        return Vector3D.Cross(b - a, c - a);
    }
}
