using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Lod;
using Msisf.Core.Preview;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preview;

/// <summary>Tells what the images of a run will show, and draws nothing: no file is written, and no folder made.</summary>
internal static class DryRun
{
    /// <summary>Reads the run and looks through each camera; notes what is striking about the whole run.</summary>
    /// <param name="cameras">The run's other settings: those of each camera.</param>
    /// <returns>A row for each frame that would be made.</returns>
    public static IReadOnlyList<PreviewRow> Of(
        TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(cameras[0], host);
        using ModelOnDemand onDemand = new(cameras[0], host, cancellation);
        IReadOnlyList<RunFrames> run = RunFrames.Read(trajectory, cameras, ephemeris, onDemand, host, cancellation);
        return [.. run.SelectMany(camera => Of(trajectory, camera, onDemand, ephemeris, host, cancellation)).OrderBy(row => row.Step)];
    }

    private static PreviewRow[] Of(
        TrajectorySettings trajectory, RunFrames run, ModelOnDemand onDemand, EphemerisSource ephemeris, ProgramHost host,
        CancellationToken cancellation)
    {
        RenderSettings settings = run.Settings;
        ProductTable.RefuseInStrips(settings);
        ElevationModel? model = IfThere(onDemand, settings, host);
        GroundCheck.Refuse(run.Frames, model, settings.ShutterSpan, cancellation, settings.Body, trajectory);
        using SignalPreview? signal = Signal(settings, run, onDemand, ephemeris, host, cancellation);
        double reference = model?.Grid.ReferenceRadius ?? MoonConstants.ReferenceRadius;
        GridResolution resolution = settings.Resolution.OnSphere(reference);
        run.WarnOfCamera(host, reference);
        RunNotes notes = new(resolution, settings.Ldem.Count > 1, settings.Native.Refine is not null) { Camera = settings.Rig?.Name };
        IFrameTerrain? detail = model?.Grid is { PartCount: > 1, InventedName: null } ? model.DetailOf(settings.LevelOfDetailError) : null;
        PreviewRow[] rows = host.Times.Measure(Phase.Preview, () => run.Frames.Select(frame =>
        {
            cancellation.ThrowIfCancellationRequested();
            FramePreview view = FramePreview.Of(frame.Camera, frame.Light, model?.Grid, model?.Tracer);
            notes.Add(frame, view);
            return new PreviewRow(
                frame.Step, frame.Time, Height(frame.Camera.PositionBodyFixed, model), view, view.PixelsPerCell(resolution))
            {
                Camera = settings.Rig?.Name,
                HasSignal = signal is not null,
                Signal = signal?.Of(frame, cancellation),
                Drawn = detail?.For(frame.Camera, settings.DetailSubsamplesPerAxis).DrawnResolutions ?? [],
            };
        }).ToArray());
        notes.Write(settings.Rig is null or { Index: 0 } ? trajectory : null, host.Log);
        signal?.WriteNote(host.Log);
        if (model is not null && !settings.IgnoreSun && LandingLight.IsLanding([.. rows.Select(row => row.HeightOverGround)]))
        {
            new LandingLight(model, ephemeris.Engine(), settings.Body.IsMoon).Write(
                run.Frames[^1].Camera.PositionBodyFixed, run.Frames[^1].Time, host.Log, cancellation);
        }

        return rows;
    }

    /// <summary>What tells the numbers of a detector; null without one, or without a model to draw small images of.</summary>
    private static SignalPreview? Signal(
        RenderSettings settings, RunFrames run, ModelOnDemand model, EphemerisSource ephemeris, ProgramHost host,
        CancellationToken cancellation)
    {
        if (settings.Native.Detector is null || !(model.IsOpen || settings.Native.FindsExposureTime))
        {
            return null;
        }

        SurfaceInputs maps = SurfaceInputs.Open(settings, host);
        RenderSettings exposed = ExposureSearch.Resolve(
            settings, run.States, run.Frames, model.Opened, maps, ephemeris.Engine, host, cancellation);
        return new SignalPreview(exposed, run.States[0].Noise is not null, model.Opened, maps, host.Times);
    }

    private static ElevationModel? IfThere(ModelOnDemand model, RenderSettings settings, ProgramHost host)
    {
        if (model.IsOpen || settings.Ldem.Count > 0 || ModelOpening.IsThere(settings.Resolution.PixelsPerDegree!.Value, host))
        {
            return model.Opened;
        }

        host.Log.Note(Invariant(
            $"No elevation model of {settings.Resolution} is there: heights are over the sphere of "
                + $"{MoonConstants.ReferenceRadius:F0} m. Drawing needs the model."));
        return null;
    }

    private static double Height(Vector3D position, ElevationModel? model) =>
        position.Length - (model is null ? MoonConstants.ReferenceRadius : TerrainHeight.RadiusBelow(model.Grid, position));
}

/// <summary>What one image will show: a line of the table of <c>--dry-run</c>.</summary>
/// <param name="Step">Number of the frame, from 1, in the order of the input.</param>
/// <param name="Time">Time, UTC.</param>
/// <param name="HeightOverGround">Height of the camera over the terrain, m; over the reference sphere if there is no model.</param>
/// <param name="PixelsPerCell">Width of a cell of the model in the middle of the image, px; null if that shows no ground.</param>
internal sealed record PreviewRow(int Step, Instant Time, double HeightOverGround, FramePreview View, double? PixelsPerCell)
{
    /// <summary>Name of the rig's camera; null without a rig.</summary>
    public string? Camera { get; init; }

    /// <summary>
    /// Resolution at which each of several models would be drawn, coarsest first; null for one that is left out. Empty for
    /// one model, and with invented detail, below which models are drawn as they are.
    /// </summary>
    public IReadOnlyList<GridResolution?> Drawn { get; init; } = [];

    /// <summary>Whether the camera has a detector whose numbers are shown.</summary>
    public bool HasSignal { get; init; }

    /// <summary>What the detector gives for lit ground; null if none is in the image.</summary>
    public SignalLevels? Signal { get; init; }
}
