using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.Adapters.Tiles;
using Msisf.Cli.Options;
using Msisf.Cli.Progress;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Run;

/// <summary>A whole run: states, Sun, frames, and what is printed about them.</summary>
internal sealed class RenderRun : IDisposable
{
    private readonly RenderSettings _settings;
    private readonly ProgramHost _host;
    private readonly RunTimes _times;
    private OpenedEphemeris? _ephemeris;

    public RenderRun(RenderSettings settings, ProgramHost host)
    {
        _settings = settings;
        _host = host;
        _times = host.Times;
    }

    /// <summary>The ephemeris engine, opened when it is first needed.</summary>
    public IEphemeris Ephemeris()
    {
        if (_ephemeris is null)
        {
            Installation installation = _host.Installation;
            _ephemeris = EphemerisFactory.Open(new EphemerisRequest(
                _settings.Ephemeris, [_settings.Kernels ?? installation.MetaKernel], installation.Root, _host.Environment("MSISF_CSPICE")));
            _host.Log.Note(_ephemeris.Notice);
        }

        return _ephemeris.Engine;
    }

    /// <summary>Does the run.</summary>
    /// <param name="readStates">Reads all states.</param>
    /// <param name="cancellation">Ends POV-Ray and leaves no half file.</param>
    public async Task RunAsync(Func<IReadOnlyList<SpacecraftState>> readStates, CancellationToken cancellation)
    {
        IReadOnlyList<SpacecraftState> states = _times.Measure(Phase.States, readStates);
        Frame[] frames = _times.Measure(Phase.Sun, () => FramePlanner.Plan(states, _settings, Ephemeris, cancellation));
        using ElevationModel model = _times.Measure(Phase.Model, () => ElevationModel.Open(
            _settings.Ldem, _settings.PixelsPerDegree, isSparing: _settings.Renderer == RendererKind.PovRay, _host));
        FramePlanner.RefuseCamerasInTheGround(frames, model, cancellation);
        if (_settings.ListPatterns)
        {
            PatternList.Print(frames, model, _host.Results, cancellation);
            return;
        }

        IReadOnlyList<FrameOutputs> outputs = await RenderAsync(frames, model, cancellation).ConfigureAwait(false);
        if (_settings.Timing)
        {
            _host.Log.Raw(_times.ToJson(outputs.Count, outputs.Sum(frame => (long)frame.TileCount), outputs.Sum(frame => frame.PatternsMade)));
        }
    }

    public void Dispose() => _ephemeris?.Dispose();

    private async Task<IReadOnlyList<FrameOutputs>> RenderAsync(Frame[] frames, ElevationModel model, CancellationToken cancellation)
    {
        if (_settings.Annotate)
        {
            AnnotationRenderer.RequireCairo();
        }

        if (_settings.Native is { Layers: not null, LayersFormat: LayersFormat.Fits })
        {
            FitsLayerWriter.RequireCFitsio();
        }

        FrameFiles files = new(_settings, model.Grid, _host.Identity, _times);
        int cores = Environment.ProcessorCount;
        int atOnce = FrameLoop.AtOnce(frames.Length, _settings.Jobs, cores);
        using IFrameRenderer renderer = _settings.Renderer == RendererKind.Native ? Native(model, files) : PovRay(model, files, atOnce);
        CreateFolder(_settings.OutputFolder);
        ResourceCheck.Check(
            _settings,
            atOnce,
            GC.GetGCMemoryInfo().TotalAvailableMemoryBytes,
            new DriveInfo(Path.GetFullPath(_settings.OutputFolder)).AvailableFreeSpace);

        // A bar overwrites what is printed on its terminal: errors and paths follow when it is done.
        bool hasBar = RunProgress.DrawsBar(frames.Length, _settings.Unattended);
        bool isPrintedLater = hasBar && !Console.IsOutputRedirected;
        using StringWriter later = new(CultureInfo.InvariantCulture);
        using StringWriter laterErrors = new(CultureInfo.InvariantCulture);
        try
        {
            using IRunProgress progress = RunProgress.Start("Frames", frames.Length, _settings.Unattended, _host.Log, _host.Clock);
            FrameLoop loop = new(renderer.RenderAsync, renderer.FramesAhead, progress, isPrintedLater ? later : _host.Results, hasBar ? new Log(laterErrors) : _host.Log);
            return await loop.RunAsync(frames, _settings.Jobs, cores, cancellation).ConfigureAwait(false);
        }
        finally
        {
            if (laterErrors.ToString() is { Length: > 0 } errors)
            {
                _host.Log.Raw(errors.TrimEnd());
            }

            _host.Results.Write(later.ToString());
        }
    }

    private PovRayFrameRenderer PovRay(ElevationModel model, FrameFiles files, int processes)
    {
        PovRayProcess povRay = new(PovRayProgram.Find(_settings.PovPath, _host.Environment("PATH") ?? string.Empty));
        ScenePatterns patterns = new(new PatternRepository(_settings.PatternRepository), new LevelMeshBuilders(model.Grid, () => model.Levels));
        return new PovRayFrameRenderer(_settings, model, patterns, povRay, processes, files, _times);
    }

    private NativeFrameRenderer Native(ElevationModel model, FrameFiles files)
    {
        NativeLevels levels = new(model.Grid, () => model.Levels, _settings.LevelOfDetailError);
        return new NativeFrameRenderer(_settings.Native, model.Grid, levels, files, _times);
    }

    private static void CreateFolder(string folder)
    {
        try
        {
            Directory.CreateDirectory(folder);
            WorkFolder.RemoveStale(folder);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"--output-dir {folder}: the folder can't be made: {exception.Message}", exception);
        }
    }
}
