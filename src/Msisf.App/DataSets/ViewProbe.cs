using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Preview;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.App.DataSets;

/// <summary>Tells what an image will show from a small one of the same view, with terrain and shadows. Thread-safe.</summary>
internal sealed class ViewProbe
{
    /// <summary>px: longer side of the small image.</summary>
    private const int LongerSide = 48;

    private readonly CameraModel _camera;
    private readonly NativeDrawing _drawing;

    /// <summary>Prepares the small images.</summary>
    /// <param name="times">Receives the times.</param>
    public ViewProbe(RenderSettings settings, ElevationModel model, SurfaceInputs maps, RunTimes times)
    {
        NativeSettings native = settings.Native;
        NativeSettings small = native with
        {
            Detector = null,
            Layers = null,
            Navigation = null,
            Render = native.Render with { KeepGroundTruth = true, SubsamplesPerAxis = 1, Adaptive = null, Indirect = null },
        };
        _camera = ReducedCamera.ModelOf(settings.CameraModel, LongerSide);
        _drawing = new NativeDrawing(small, model.Grid, maps, new NativeLevels(model.DetailOf(settings.LevelOfDetailError)), times);
    }

    /// <summary>Looks at the view of a frame.</summary>
    public View Of(Frame frame, CancellationToken cancellation)
    {
        using NativeImage image = _drawing.Draw(
            frame with { Camera = _camera.At(frame.Camera.Bands[0].Camera.State), Motion = null, Noise = null, Flow = null },
            threads: 1,
            cancellation);
        IGroundTruth truth = image.ToRendered(Stream.Null).Truth!;
        List<Vector3D> points = [];
        int lit = 0;
        for (int y = 1; y <= _camera.Height; y++)
        {
            for (int x = 1; x <= _camera.Width; x++)
            {
                if (truth.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
                {
                    points.Add(hit.PointBodyFixed);
                    lit += light.VisibleFraction > 0.0 ? 1 : 0;
                }
            }
        }

        double ground = (double)points.Count / (_camera.Width * _camera.Height);
        return new View(ground, points.Count > 0 ? (double)lit / points.Count : 0.0, points);
    }
}

/// <summary>What an image shows.</summary>
/// <param name="Ground">The part of it that shows ground.</param>
/// <param name="Lit">The part of that ground that gets light.</param>
/// <param name="Points">Points of the ground, m, body-fixed.</param>
internal sealed record View(double Ground, double Lit, IReadOnlyList<Vector3D> Points);
