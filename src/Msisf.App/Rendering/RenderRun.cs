using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>Renders the missing and incomplete frames of a run with the selected renderer.</summary>
internal sealed class RenderRun
{
    private readonly ProgramHost _host;
    private readonly RunTimes _times;
    private RenderSettings _settings;

    private RenderRun(RenderSettings settings, ProgramHost host) => (_settings, _host, _times) = (settings, host, host.Times);

    /// <summary>Renders the frames; the paths of their files are written to the host's results.</summary>
    /// <param name="trajectory">The positions of the camera.</param>
    /// <param name="settings">The other settings.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Cancels the work and ends POV-Ray; no incomplete file is left.</param>
    /// <returns>The files of all frames, including those that already existed.</returns>
    /// <exception cref="MsisfException">
    /// The run can't be made, or a frame failed; in the second case the other frames are complete.
    /// </exception>
    public static Task<IReadOnlyList<FrameOutputs>> RunAsync(
        TrajectorySettings trajectory, RenderSettings settings, ProgramHost host, CancellationToken cancellation) =>
        new RenderRun(settings, host).RunAsync(trajectory, cancellation);

    private async Task<IReadOnlyList<FrameOutputs>> RunAsync(TrajectorySettings trajectory, CancellationToken cancellation)
    {
        _times.BeginRun();
        using EphemerisSource ephemeris = new(_settings, _host);

        // The checksums take long and are needed late, so they are started first.
        using RunInputs inputs = new(
            () => _settings.NeedsKernels ? ephemeris.KernelFiles() : [], _settings.Camera, _host, cancellation);
        Task<string>? povRayVersion = _settings.Renderer == RendererKind.PovRay
            ? Task.Run(() => PovRayVersion.AskAsync(FindPovRay()), cancellation)
            : null;
        using PreparedRun run = PreparedRun.Of(trajectory, _settings, ephemeris, _host, cancellation);
        using SurfaceInputs maps = _times.Measure(Phase.Model, () => SurfaceInputs.Open(_settings, _host));
        NavigationInputs? navigation = _times.Measure(
            Phase.Navigation, () => NavigationInputs.Open(_settings.Native.Navigation, run.Model.Grid.ReferenceRadius));
        IReadOnlyList<InputFile> files =
        [
            .. maps.Files, .. navigation?.Files ?? [], .. _settings.Jitter is { } jitter ? [jitter.ToInput()] : (InputFile[])[],
        ];
        inputs.Begin(run.Model.Sets, files);
        RequireParts();
        _settings = ExposureSearch.Resolve(_settings, run.States, run.Frames, run.Model, maps, ephemeris.Engine, _host, cancellation);
        _times.Measure(Phase.Preview, () => RunNotes.Write(trajectory, run.Frames, run.Model.Grid, _host.Log, cancellation));
        string? version = povRayVersion is null ? null : await povRayVersion.ConfigureAwait(false);
        IReadOnlyList<InputFile> kernels = await inputs.Kernels.ConfigureAwait(false);
        OpenedEphemeris? sun = _settings.IgnoreSun ? null : ephemeris.Opened;
        RunPlan plan = _times.Measure(Phase.Manifest, () => new RunPlan(
            run.States,
            run.Names,
            RunIdentity.Of(
                _host.Version,
                FrameArguments.OfSettings(_settings, sun?.Choice, maps.WholeAlbedo),
                run.Model.Fingerprint(),
                sun?.Engine.EngineName,
                kernels,
                version,
                files)));
        IEphemeris? ofModels = _settings.CameraFormats.Any(format => format.NeedsEphemeris) ? ephemeris.Engine() : null;
        return await RenderAsync(run, plan, inputs, maps, (navigation, ofModels), cancellation).ConfigureAwait(false);
    }

    /// <summary>Checks for the libraries that some options need, before any work is done.</summary>
    private void RequireParts()
    {
        if (_settings.Annotate)
        {
            AnnotationRenderer.RequireCairo();
        }

        if (_settings.Native is { Layers: not null, LayersFormat: LayersFormat.Fits } or { Detector.WritesFits: true }
            || _settings.Native.Navigation is { } wanted && wanted.FlowFormatNames?.Contains("fits") == true)
        {
            FitsLayerWriter.RequireCFitsio();
        }
    }

    private string FindPovRay() =>
        PovOptions.Program.NamedInErrors(() => PovRayProgram.Find(_settings.PovPath, _host.Environment("PATH") ?? string.Empty));

    private async Task<IReadOnlyList<FrameOutputs>> RenderAsync(
        PreparedRun run, RunPlan plan, RunInputs inputs, SurfaceInputs maps,
        (NavigationInputs? Navigation, IEphemeris? OfModels) truth, CancellationToken cancellation)
    {
        IReadOnlyList<Frame> frames = run.Frames;
        CreateFolder(_settings.OutputFolder);
        using FrameLedger ledger = _times.Measure(
            Phase.Manifest, () => new FrameLedger(_settings.OutputFolder, plan, _settings.Overwrite, _host.Log));
        FrameOutputs?[] known = _times.Measure(Phase.Manifest, () => Known(frames, ledger));
        int missing = known.Count(outputs => outputs is null);
        int cores = Environment.ProcessorCount;
        long memory = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        int atOnce = ResourceCheck.AtOnce(_settings, missing, cores, memory);
        ResourceCheck.Check(_settings, missing, atOnce, memory, new DriveInfo(Path.GetFullPath(_settings.OutputFolder)).AvailableFreeSpace);
        InputComparison comparison = new(_host.Log);
        FrameDescription description = new(_settings, run.Model, ledger.Plan.Identity.Version, inputs.All)
        {
            Orientation = run.Orientation,
        };
        FrameFiles files = new(_settings, description, comparison, ledger, _times, truth.Navigation, truth.OfModels);
        ExposureNote? exposure = _settings.Native.Detector is { } detector
            ? new ExposureNote(detector.Settings, isNoiseChosen: run.States[0].Noise is not null)
            : null;
        using IFrameRenderer renderer = _settings.Renderer == RendererKind.Native
            ? Native(run.Model, maps, files, exposure)
            : PovRay(run.Model, maps.Albedo, files, atOnce, ResourceCheck.SmallScenesAtOnce(_settings, atOnce, memory));
        using FrameTimes frameTimes = new(_settings.FrameTimes);
        FrameMaker maker = new(renderer.RenderAsync, ledger, frameTimes);

        using IRunProgress progress = _host.Progress.Start("Frames", missing, _settings.Unattended);
        FrameLoop loop = new(maker, renderer.FramesAhead, _settings.FailFast, progress, _host.Results, _host.Log);
        try
        {
            IReadOnlyList<FrameOutputs> outputs = await loop.RunAsync(frames, known, atOnce, cores, cancellation).ConfigureAwait(false);
            Compare(known, inputs, comparison);
            return outputs;
        }
        finally
        {
            exposure?.Write(_host.Log);
        }
    }

    /// <summary>Compares the input files of the frames that were there before with those of this run.</summary>
    private static void Compare(IReadOnlyList<FrameOutputs?> known, RunInputs inputs, InputComparison comparison)
    {
        foreach (string metaFile in known.OfType<FrameOutputs>().SelectMany(outputs => outputs.Paths)
            .Where(path => Path.GetExtension(path) == ".xml"))
        {
            comparison.Compare(metaFile, inputs.All());
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
            _host.Log.Note(string.Create(
                CultureInfo.InvariantCulture,
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
        ISceneSurface surface = SceneSurfaces.Of(model, _settings);
        PovAlbedo? albedo = map is null ? null : new PovAlbedo(map, surface.Folder);
        return new PovRayFrameRenderer(_settings, surface, povRay, albedo, processes, smallProcesses, files, _times);
    }

    private NativeFrameRenderer Native(ElevationModel model, SurfaceInputs maps, FrameFiles files, ExposureNote? exposure)
    {
        NativeLevels levels = new(model.DetailOf(_settings.LevelOfDetailError));
        return new NativeFrameRenderer(new NativeDrawing(_settings.Native, model.Grid, maps, levels, _times), files, exposure, _times);
    }

    private static void CreateFolder(string folder) => OutputOptions.Folder.NamedInErrors(
        () => FileErrors.ToExternalPart($"--output-dir {folder}: the folder can't be made", () =>
        {
            Directory.CreateDirectory(folder);
            WorkFolder.RemoveStale(folder);
        }));
}
