using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Certainty;

/// <summary>
/// Bounds of what an image shows while the heights of the ground, the camera's pose and the Sun's direction are known within limits only
/// (docs/sensitivities.md). They are proven for everything within the limits: beams stand for all rays of a sample, and intervals for all
/// angles of what they can meet.
/// </summary>
/// <param name="terrain">The surface as it is drawn.</param>
/// <param name="options">How it is drawn.</param>
/// <param name="uncertainty">The limits.</param>
public sealed class CertainPixels(ITerrain terrain, NativeRenderOptions options, Uncertainty uncertainty)
{
    private readonly SurfaceModel _surface = SurfaceModel.Of(terrain);

    /// <summary>Finds the bounds of an image.</summary>
    /// <param name="camera">A camera with one state, above the ground.</param>
    /// <param name="light">The Sun.</param>
    /// <param name="threads">Number of threads, at least 1; the result does not depend on it.</param>
    /// <exception cref="BadInputException">The image has something of which no bounds are known.</exception>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public CertainImage Find(FrameCamera camera, SceneLight light, int threads, CancellationToken cancellation)
    {
        Refuse(light);
        CertainImage image = new(camera.Width, camera.Height);
        double distance = light.PositionBodyFixed.Length;
        double sunAngle = uncertainty.Sun + SampleBounds.DiscSlopeOf(light, options)
            + BandSearch.AngleOf(_surface.RadiusLimits.Max + uncertainty.Height + Tolerances.VertexLattice, distance);
        SampleBounds?[] workers = new SampleBounds?[threads];
        WorkerTeam.Run(
            threads,
            camera.Height,
            (worker, row) => (workers[worker] ??= NewWorker()).FindRow(row, image),
            cancellation);
        return image;

        SampleBounds NewWorker() => new(
            new BandSearch(_surface, uncertainty.Height, light.PositionBodyFixed / distance, sunAngle), camera, light, options,
            uncertainty);
    }

    private void Refuse(SceneLight light)
    {
        (string What, string ToDo)? refused =
            !_surface.IsClosed ? ("maps without a model of the whole Moon", "Add one by --ldem")
            : !light.IsSun ? ("a lamp at the camera", "Leave --ignore-sun out")
            : options.Hapke is not null ? ("a law that differs from place to place", "Leave --hapke-map out")
            : options.Reflectance is not IEnclosedLaw
                ? ("this law", "Choose moon, hapke, lunar-lambert, lommel-seeliger or lambert by --reflectance")
            : options.Adaptive is not null ? ("samples that depend on the image", "Give --samples a number")
            : options.Normals == NormalModel.Smooth ? ("smooth ground", "Give --shading facet")
            : options.Indirect is not null ? ("light from the ground", "Leave --indirect out")
            : options.Second is not null ? ("earthshine", "Leave --earthshine out")
            : _surface.Brightness is not null ? ("invented detail", "Leave --refine out")
            : options.AlbedoSites.Count > 0
                ? ("maps of the reflectance of a part of the Moon", "Give one of the whole Moon by --albedo-map")
            : null;
        if (refused is { } reason)
        {
            throw new BadInputException(
                $"Which pixels are certain is not known with {reason.What}. {reason.ToDo}, or leave --certify out.");
        }
    }
}
