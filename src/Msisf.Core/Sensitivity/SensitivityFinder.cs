using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Sensitivity;

/// <summary>
/// Finds the derivatives of an image's pixels (docs/sensitivities.md). The image is drawn once with samples on a grid, which includes the
/// pixels' corners, so that no change between samples belongs to two pixels. Between two neighbouring samples brightness changes by what
/// lies there: a slope, an edge of facets, a silhouette or the border of a shadow. Each change moves with the nearer of the two samples, or
/// with the shadow's caster, so that no edge need be found.
/// </summary>
/// <param name="renderer">Draws the surface.</param>
/// <param name="tracer">Traces single rays through the same surface: finds what casts a shadow.</param>
/// <param name="options">The frame's; samples and ground truth do not matter.</param>
public sealed class SensitivityFinder(NativeRenderer renderer, ITerrainTracer tracer, NativeRenderOptions options)
{
    /// <summary>Steps of the grid along a pixel's edge: fewer miss thin shadows, more cost more.</summary>
    public const int SamplesPerAxis = 6;

    /// <summary>Samples that are drawn at once; bounds the memory.</summary>
    private const int SamplesAtOnce = 1 << 21;

    /// <summary>Rows of pixels that a thread takes at once: at the borders rows of samples are read twice.</summary>
    private const int RowsAtOnce = 8;

    /// <summary>Finds the derivatives.</summary>
    /// <param name="camera">A camera with one state.</param>
    /// <param name="light">The Sun.</param>
    /// <param name="threads">Number of threads, at least 1; the result does not depend on it.</param>
    /// <exception cref="BadInputException">The light is a lamp.</exception>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public SensitivityField Find(FrameCamera camera, SceneLight light, int threads, CancellationToken cancellation)
    {
        if (!light.IsSun)
        {
            throw new BadInputException("Sensitivities need the Sun: a lamp at the camera moves with it. Leave --ignore-sun out.");
        }

        SensitivityField field = new(camera.Width, camera.Height);
        NativeRenderOptions ofSamples = options with
        {
            SubsamplesPerAxis = 1,
            Adaptive = null,
            KeepGroundTruth = true,
            Indirect = null,
            Second = null,
            Progress = null,
        };
        CameraModel grid = ChangedCamera.Grid(camera.Model, SamplesPerAxis);
        int rows = Math.Clamp(SamplesAtOnce / (grid.Width * SamplesPerAxis), 1, camera.Height);
        int strips = (camera.Height + rows - 1) / rows;
        foreach (PixelRows strip in PixelRows.Strips(camera.Height, strips, 1))
        {
            FrameCamera window = grid.Window(
                0, strip.First * SamplesPerAxis, grid.Width, ((strip.End - strip.First) * SamplesPerAxis) + 1).At(camera.State);
            using NativeFrame samples = renderer.Render(window, light, ofSamples, threads, cancellation);
            int tasks = (strip.End - strip.First + RowsAtOnce - 1) / RowsAtOnce;
            SampledStrip read = new(samples, tracer, renderer.CornersOf, camera, strip, ofSamples);
            WorkerTeam.Run(
                threads,
                tasks,
                (_, task) => read.Find(
                    new PixelRows(
                        strip.First + (task * RowsAtOnce), Math.Min(strip.End, strip.First + ((task + 1) * RowsAtOnce))),
                    field),
                cancellation);
        }

        return field;
    }
}
