using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>Renders the missing and incomplete frames of a run with the selected renderer.</summary>
internal sealed class RenderRun
{
    private readonly ProgramHost _host;
    private readonly RunTimes _times;

    /// <summary>Settings of each camera of the rig, or of the only one: they differ in what a rig says of a camera.</summary>
    private RenderSettings[] _cameras;

    private RenderRun(IReadOnlyList<RenderSettings> cameras, ProgramHost host) =>
        (_cameras, _host, _times) = ([.. cameras], host, host.Times);

    private RenderSettings Settings => _cameras[0];

    /// <summary>Renders the frames; the paths of their files are written to the host's results.</summary>
    /// <param name="trajectory">The positions of the camera, or of the body that carries several.</param>
    /// <param name="cameras">The other settings: those of each camera.</param>
    /// <param name="cancellation">Cancels the work and ends POV-Ray; no incomplete file is left.</param>
    /// <returns>The files of all frames, including those that already existed.</returns>
    /// <exception cref="MsisfException">
    /// The run can't be made, or a frame failed; in the second case the other frames are complete.
    /// </exception>
    public static Task<IReadOnlyList<FrameOutputs>> RunAsync(
        TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras, ProgramHost host, CancellationToken cancellation) =>
        new RenderRun(cameras, host).RunAsync(trajectory, cancellation);

    private async Task<IReadOnlyList<FrameOutputs>> RunAsync(TrajectorySettings trajectory, CancellationToken cancellation)
    {
        _times.BeginRun();
        foreach (RenderSettings camera in _cameras)
        {
            ProductTable.RefuseInStrips(camera);
        }

        using EphemerisSource ephemeris = new(Settings, _host);

        // The checksums take long and are needed late, so they are started first.
        using RunInputs inputs = new(() => Settings.NeedsKernels ? ephemeris.KernelFiles() : [], _host, cancellation);
        Task<string>? povRayVersion = Settings.Renderer == RendererKind.PovRay
            ? Task.Run(() => PovRayProgram.VersionOfAsync(FindPovRay()), cancellation)
            : null;
        using PreparedRun run = PreparedRun.Of(trajectory, _cameras, ephemeris, _host, cancellation);
        using SurfaceInputs maps = _times.Measure(Phase.Model, () => SurfaceInputs.Open(Settings, _host));
        NavigationInputs? navigation = _times.Measure(
            Phase.Navigation, () => NavigationInputs.Open(Settings.Native.Navigation, run.Model.Grid.ReferenceRadius));
        SkyInputs? sky = _times.Measure(Phase.Sky, () => SkyInputs.Open(Settings.Native.Sky, _host.Log));
        IReadOnlyList<InputFile> files =
        [
            .. maps.Files, .. navigation?.Files ?? [], .. sky?.Files ?? [],
            .. Settings.Jitter is { } jitter ? [jitter.ToInput()] : (InputFile[])[],
            .. Settings.RigFile is { } rig ? [rig] : (InputFile[])[],
        ];
        inputs.Begin(run.Model.Sets, files);
        RequireParts();
        _cameras = [.. run.Cameras.Select(camera => ExposureSearch.Resolve(
            camera.Settings, camera.States, camera.Frames, run.Model, maps, ephemeris.Engine, _host, cancellation))];
        _times.Measure(Phase.Preview, () => RunNotes.Write(trajectory, run.Cameras, run.Model.Grid, _host.Log, cancellation));
        string? version = povRayVersion is null ? null : await povRayVersion.ConfigureAwait(false);
        IReadOnlyList<InputFile> kernels = await inputs.Kernels.ConfigureAwait(false);
        OpenedEphemeris? sun = Settings.IgnoreSun ? null : ephemeris.Opened;
        RunPlan plan = _times.Measure(Phase.Manifest, () =>
        {
            LdemFingerprint model = run.Model.Fingerprint();
            return new RunPlan([.. run.Cameras.Zip(_cameras, (camera, settings) => new PlannedCamera(
                camera.States,
                camera.Names,
                RunIdentity.Of(
                    _host.Version,
                    FrameArguments.OfSettings(settings, sun?.Choice, maps.WholeAlbedo),
                    model,
                    sun?.Engine.EngineName,
                    kernels,
                    version,
                    files)))]);
        });
        IEphemeris? ofModels = Settings.CameraFormats.Any(format => format.NeedsEphemeris) ? ephemeris.Engine() : null;
        return await RenderAsync(run, plan, inputs, maps, (navigation, ofModels), sky, cancellation).ConfigureAwait(false);
    }

    /// <summary>Checks for the libraries that products need, before any work is done.</summary>
    private void RequireParts()
    {
        foreach (Product product in ProductTable.Of(Settings))
        {
            product.Require(Settings, GdalPath);
        }
    }

    private string? GdalPath => _host.Environment("MSISF_GDAL");

    private string FindPovRay() =>
        PovOptions.Program.NamedInErrors(() => PovRayProgram.Find(Settings.PovPath, _host.Environment("PATH") ?? string.Empty));

    private async Task<IReadOnlyList<FrameOutputs>> RenderAsync(
        PreparedRun run, RunPlan plan, RunInputs inputs, SurfaceInputs maps,
        (NavigationInputs? Navigation, IEphemeris? OfModels) truth, SkyInputs? sky, CancellationToken cancellation)
    {
        IReadOnlyList<Frame> frames = run.Frames;
        RequireRoom(frames, FrameLedger.AreThere(Settings.OutputFolder, plan, frames, Settings.Overwrite));
        CreateFolder(Settings.OutputFolder);
        using FrameLedger ledger = _times.Measure(
            Phase.Manifest, () => new FrameLedger(Settings.OutputFolder, plan, Settings.Overwrite, _host.Log));
        FrameOutputs?[] known = _times.Measure(Phase.Manifest, () => Known(frames, ledger));
        int missing = known.Count(outputs => outputs is null);
        int cores = Environment.ProcessorCount;
        int atOnce = AtOnce(missing);

        InputComparison comparison = new(_host.Log);
        CraterNote craters = new(run.Model.Grid.Resolution.OnSphere(run.Model.Grid.ReferenceRadius).MetresPerPixel);
        FrameFiles[] files = [.. _cameras.Select(settings => new FrameFiles(
            settings,
            new FrameDescription(settings, run.Model, plan.Version, () => inputs.All(settings.Camera)) { Orientation = run.Orientation },
            comparison, ledger, _times, new ProductTools(_host.Log, GdalPath, truth.OfModels), truth.Navigation,
            craters))];
        ExposureNote?[] exposures = [.. _cameras.Zip(run.Cameras, (settings, camera) => settings.Native.Detector is { } detector
            ? new ExposureNote(detector.Settings, isNoiseChosen: camera.States[0].Noise is not null)
            : null)];
        bool isLong = Settings.Renderer == RendererKind.Native && Settings.Native.Render.Indirect is not null;
        using IRunProgress display = _host.Progress.Start("Frames", missing * FrameProgress.StepsOf(isLong), Settings.Unattended);
        FrameProgress progress = new(display, isLong);
        using RendererOfRun renderer = new(Settings.Renderer == RendererKind.Native
            ? Native(run.Model, (maps, sky), files, exposures, progress)
            : [PovRay(run.Model, maps.Albedo, files[0], atOnce, ResourceCheck.SmallScenesAtOnce(Settings, atOnce, MemoryThere))]);
        using FrameTimes frameTimes = new(Settings.FrameTimes);
        FrameMaker maker = new(renderer.RenderAsync, ledger, frameTimes);

        FrameLoop loop = new(maker, renderer.FramesAhead, Settings.FailFast, progress, _host.Results, _host.Log);
        try
        {
            IReadOnlyList<FrameOutputs> outputs = await loop.RunAsync(frames, known, atOnce, cores, cancellation).ConfigureAwait(false);
            Compare(frames, known, inputs, comparison);
            return outputs;
        }
        finally
        {
            foreach (ExposureNote exposure in exposures.OfType<ExposureNote>())
            {
                exposure.Write(_host.Log);
            }

            craters.Write(_host.Log);
        }
    }

    private static long MemoryThere => GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;

    private int AtOnce(int missing) =>
        _cameras.Min(settings => ResourceCheck.AtOnce(settings, missing, Environment.ProcessorCount, MemoryThere));

    /// <summary>Checks memory and disk before anything is written.</summary>
    private void RequireRoom(IReadOnlyList<Frame> frames, bool[] areThere)
    {
        ResourceCheck.Check(
            [.. _cameras.Select((settings, index) =>
                (settings, frames.Zip(areThere).Count(pair => !pair.Second && pair.First.CameraIndex == index)))],
            AtOnce(areThere.Count(isThere => !isThere)), MemoryThere, DiskRoom.Of(Settings.OutputFolder));
    }

    /// <summary>Compares the input files of the frames that were there before with those of this run.</summary>
    private void Compare(IReadOnlyList<Frame> frames, IReadOnlyList<FrameOutputs?> known, RunInputs inputs, InputComparison comparison)
    {
        foreach ((Frame frame, FrameOutputs? outputs) in frames.Zip(known))
        {
            foreach (string metaFile in (outputs?.Paths ?? []).Where(path => Path.GetExtension(path) == ".xml"))
            {
                comparison.Compare(metaFile, inputs.All(_cameras[frame.CameraIndex].Camera));
            }
        }
    }

    /// <summary>
    /// The outputs of the frames that exist and are complete, and null for the others; logs the number of frames in each state if any
    /// exist.
    /// </summary>
    private FrameOutputs?[] Known(IReadOnlyList<Frame> frames, FrameLedger ledger)
    {
        FrameState[] states = new FrameState[frames.Count];
        Parallel.For(0, frames.Count, index => states[index] = ledger.Check(frames[index]).State);
        int Count(FrameState state) => states.Count(found => found == state);
        int complete = Count(FrameState.Complete);
        if (complete + Count(FrameState.Damaged) + Count(FrameState.OtherSettings) > 0)
        {
            _host.Log.Note(Invariant(
                $"Frames: {frames.Count}, of which {complete} there and complete (--overwrite makes them again); to make: "
                    + $"{Count(FrameState.Missing) + Count(FrameState.Failed)} missing, {Count(FrameState.Damaged)} damaged, "
                    + $"{Count(FrameState.OtherSettings)} of other settings."));
        }

        return [.. frames.Zip(states, (frame, state) =>
            state == FrameState.Complete ? new FrameOutputs(ledger.PathsOf(frame), TileCount: 0, PatternsMade: 0, WasThere: true) : null)];
    }

    private PovRayFrameRenderer PovRay(ElevationModel model, OpenedAlbedoMap? map, FrameFiles files, int processes, int smallProcesses)
    {
        PovRayProcess povRay = new(FindPovRay());
        ISceneSurface surface = SceneSurfaces.Of(model, Settings);
        PovAlbedo? albedo = map is null ? null : new PovAlbedo(map, surface.Folder);
        return new PovRayFrameRenderer(Settings, surface, povRay, albedo, processes, smallProcesses, files, _times);
    }

    /// <summary>The cameras share the surface with its vertices and trees, and the memory that frames are drawn in.</summary>
    private NativeFrameRenderer[] Native(
        ElevationModel model, (SurfaceInputs Maps, SkyInputs? Sky) inputs, FrameFiles[] files, ExposureNote?[] exposures,
        FrameProgress progress)
    {
        NativeLevels levels = new(model.DetailOf(Settings.LevelOfDetailError));
        return [.. _cameras.Select((settings, index) => new NativeFrameRenderer(
            new NativeDrawing(
                settings.Native, model.Grid, inputs.Maps, levels, _times,
                inputs.Sky is { } sky ? new CameraSky(sky, settings.Albedo.Band) : null),
            files[index], exposures[index], progress, _times))];
    }

    private static void CreateFolder(string folder) => OutputOptions.Folder.NamedInErrors(
        () => FileErrors.ToExternalPart($"--output-dir {folder}: the folder can't be made", () =>
        {
            Directory.CreateDirectory(folder);
            WorkFolder.RemoveStale(folder);
        }));
}
