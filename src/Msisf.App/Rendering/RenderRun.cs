using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.Adapters.Tiles;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>A whole run: states, Sun, frames, and what is printed about them.</summary>
internal sealed class RenderRun : IDisposable
{
    private readonly RenderSettings _settings;
    private readonly ProgramHost _host;
    private readonly RunTimes _times;
    private readonly EphemerisSource _ephemeris;

    public RenderRun(RenderSettings settings, ProgramHost host)
    {
        _settings = settings;
        _host = host;
        _times = host.Times;
        _ephemeris = new EphemerisSource(settings, host);
    }

    /// <summary>The ephemeris engine, opened when it is first needed.</summary>
    public IEphemeris Ephemeris() => _ephemeris.Engine();

    /// <summary>Does the run.</summary>
    /// <param name="readStates">Reads all states.</param>
    /// <param name="cancellation">Ends POV-Ray and leaves no half file.</param>
    public async Task RunAsync(Func<IReadOnlyList<SpacecraftState>> readStates, CancellationToken cancellation)
    {
        // What takes long and is needed late begins first.
        Task<IReadOnlyList<(string Name, string Sha256)>> kernels = Task.Run(
            () => RunIdentity.ChecksumsOf(_settings.IgnoreSun || _settings.ListPatterns ? [] : _ephemeris.KernelFiles()), cancellation);
        Task<string>? povRayVersion = _settings.Renderer == RendererKind.PovRay && !_settings.ListPatterns
            ? Task.Run(AskPovRayVersion, cancellation)
            : null;
        IReadOnlyList<SpacecraftState> states = _times.Measure(Phase.States, readStates);
        IReadOnlyList<string> names = new FrameNaming(_settings.OutputName).NamesOf([.. states.Select(state => state.Time)]);
        Frame[] frames = _times.Measure(Phase.Sun, () => FramePlanner.Plan(states, names, _settings, Ephemeris, cancellation));
        using ElevationModel model = _times.Measure(Phase.Model, () => ElevationModel.Open(
            _settings.Ldem, _settings.PixelsPerDegree, isSparing: _settings.Renderer == RendererKind.PovRay, _host));
        FramePlanner.RefuseCamerasInTheGround(frames, model, cancellation);
        if (_settings.ListPatterns)
        {
            PatternList.Print(frames, model, _host.Results, cancellation);
            return;
        }

        RequireParts();
        string? version = povRayVersion is null ? null : await povRayVersion.ConfigureAwait(false);
        IReadOnlyList<(string Name, string Sha256)> checksums = await kernels.ConfigureAwait(false);
        RunPlan plan = _times.Measure(Phase.Manifest, () => new RunPlan(states, names, Identify(model, checksums, version)));
        IReadOnlyList<FrameOutputs> outputs = await RenderAsync(frames, plan, model, cancellation).ConfigureAwait(false);
        if (_settings.Timing)
        {
            _host.Log.Raw(TimingReport.Of(_times, outputs));
        }
    }

    public void Dispose() => _ephemeris.Dispose();

    /// <summary>What some options need is looked for before any work is done.</summary>
    private void RequireParts()
    {
        if (_settings.Annotate)
        {
            AnnotationRenderer.RequireCairo();
        }

        if (_settings.Native is { Layers: not null, LayersFormat: LayersFormat.Fits })
        {
            FitsLayerWriter.RequireCFitsio();
        }
    }

    private Task<string> AskPovRayVersion() =>
        PovRayVersion.AskAsync(PovRayProgram.Find(_settings.PovPath, _host.Environment("PATH") ?? string.Empty));

    private RunIdentity Identify(ElevationModel model, IReadOnlyList<(string Name, string Sha256)> kernels, string? povRayVersion)
    {
        OpenedEphemeris? sun = _settings.IgnoreSun ? null : _ephemeris.Opened;
        return RunIdentity.Of(
            _host.Version,
            FrameArguments.OfSettings(_settings, sun?.Choice),
            model.Fingerprint(),
            sun?.Engine.EngineName,
            kernels,
            povRayVersion);
    }

    private async Task<IReadOnlyList<FrameOutputs>> RenderAsync(
        Frame[] frames, RunPlan plan, ElevationModel model, CancellationToken cancellation)
    {
        CreateFolder(_settings.OutputFolder);
        using FrameLedger ledger = _times.Measure(
            Phase.Manifest, () => new FrameLedger(_settings.OutputFolder, plan, _settings.Overwrite, _host.Log));
        FrameOutputs?[] known = _times.Measure(Phase.Manifest, () => Known(frames, ledger));
        int missing = known.Count(outputs => outputs is null);
        int cores = Environment.ProcessorCount;
        long memory = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        int atOnce = ResourceCheck.AtOnce(_settings, missing, cores, memory);
        ResourceCheck.Check(_settings, missing, atOnce, memory, new DriveInfo(Path.GetFullPath(_settings.OutputFolder)).AvailableFreeSpace);
        FrameFiles files = new(_settings, model.Grid, ledger, _times);
        using IFrameRenderer renderer = _settings.Renderer == RendererKind.Native ? Native(model, files) : PovRay(model, files, atOnce);
        using FrameTimes frameTimes = new(_settings.FrameTimes);
        FrameMaker maker = new(renderer.RenderAsync, ledger, frameTimes);

        using IRunProgress progress = _host.Progress.Start("Frames", missing, _settings.Unattended);
        FrameLoop loop = new(maker, renderer.FramesAhead, _settings.FailFast, progress, _host.Results, _host.Log);
        return await loop.RunAsync(frames, known, atOnce, cores, cancellation).ConfigureAwait(false);
    }

    /// <summary>The outputs of the frames that are there and right; says how many of each there are if there is one.</summary>
    private FrameOutputs?[] Known(Frame[] frames, FrameLedger ledger)
    {
        FrameState[] states = new FrameState[frames.Length];
        Parallel.For(0, frames.Length, index => states[index] = ledger.Check(frames[index]).State);
        int Count(FrameState state) => states.Count(found => found == state);
        int right = Count(FrameState.Complete);
        if (right + Count(FrameState.Damaged) + Count(FrameState.OtherSettings) > 0)
        {
            _host.Log.Note(string.Create(
                CultureInfo.InvariantCulture,
                $"Frames: {frames.Length}, of which {right} there and right (--overwrite makes them again); to make: "
                    + $"{Count(FrameState.Missing) + Count(FrameState.Failed)} missing, {Count(FrameState.Damaged)} damaged, "
                    + $"{Count(FrameState.OtherSettings)} of other settings."));
        }

        return [.. frames.Zip(states, (frame, state) =>
            state == FrameState.Complete ? new FrameOutputs(ledger.PathsOf(frame), TileCount: 0, PatternsMade: 0, WasThere: true) : null)];
    }

    private PovRayFrameRenderer PovRay(ElevationModel model, FrameFiles files, int processes)
    {
        PovRayProcess povRay = new(PovRayProgram.Find(_settings.PovPath, _host.Environment("PATH") ?? string.Empty));
        ScenePatterns patterns = new(
            new PatternRepository(_settings.PatternRepository), new LevelMeshBuilders(model.Grid, () => model.Levels));
        return new PovRayFrameRenderer(_settings, model, patterns, povRay, processes, files, _times);
    }

    private NativeFrameRenderer Native(ElevationModel model, FrameFiles files)
    {
        NativeLevels levels = new(model.Grid, () => model.Levels, _settings.LevelOfDetailError);
        return new NativeFrameRenderer(_settings.Native, model.Grid, levels, files, _times);
    }

    private static void CreateFolder(string folder) => FileErrors.ToExternalPart($"--output-dir {folder}: the folder can't be made", () =>
    {
        Directory.CreateDirectory(folder);
        WorkFolder.RemoveStale(folder);
    });
}
