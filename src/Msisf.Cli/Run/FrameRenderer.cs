using Msisf.Adapters.IO;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.Adapters.Scene;
using Msisf.Cli.Options;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Run;

/// <summary>Makes one frame: selection, patterns, scene, POV-Ray, meta file. Its files appear when the frame is complete, the picture last. Safe for several threads.</summary>
internal sealed class FrameRenderer
{
    private readonly RenderSettings _settings;
    private readonly ElevationModel _model;
    private readonly ScenePatterns _patterns;
    private readonly PovRayProcess _povRay;
    private readonly ProgramIdentity _identity;
    private readonly RunTimes _times;

    public FrameRenderer(
        RenderSettings settings,
        ElevationModel model,
        ScenePatterns patterns,
        PovRayProcess povRay,
        ProgramIdentity identity,
        RunTimes times)
    {
        _settings = settings;
        _model = model;
        _patterns = patterns;
        _povRay = povRay;
        _identity = identity;
        _times = times;
    }

    /// <summary>Makes the frame's files.</summary>
    /// <param name="frame">Which.</param>
    /// <param name="threads">Threads that POV-Ray may use.</param>
    /// <param name="cancellation">Ends POV-Ray and leaves no file.</param>
    public async Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        TileSelection selection = _times.Measure(Phase.Selection, () => _model.Select(frame));
        TileId[] tiles = [.. selection.Kept.Select(choice => choice.Tile)];
        int made = _times.Measure(Phase.Patterns, () => _patterns.Ensure(tiles, cancellation));
        RenderScene scene = new(frame.Camera, frame.Light, _model.Grid.PixelsPerDegree, tiles);
        void WriteScene(TextWriter writer) => PovSceneWriter.Write(writer, scene, _patterns.FileNameOf);

        PovRayJob job = new(
            WriteScene,
            _patterns.Folder,
            _settings.OutputFolder,
            frame.Camera.Width,
            frame.Camera.Height,
            threads,
            _settings.PovOptions,
            _settings.Timeout);
        string[] outputs = [];
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        PovRayTimes povRayTimes = await _povRay.RenderAsync(
            job,
            picture =>
            {
                _times.Add(Phase.PovRay, System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalSeconds);
                outputs = WriteOutputs(frame, WriteScene, picture, cancellation);
            },
            cancellation).ConfigureAwait(false);
        _times.Add(Phase.Parse, povRayTimes.ParseSeconds ?? 0.0);
        _times.Add(Phase.Trace, povRayTimes.TraceSeconds ?? 0.0);
        return new FrameOutputs(outputs, tiles.Length, made);
    }

    private string[] WriteOutputs(Frame frame, Action<TextWriter> writeScene, Stream picture, CancellationToken cancellation)
    {
        string stem = Path.Combine(_settings.OutputFolder, frame.Name);
        FrameMetadata metadata = new(
            frame.Time,
            frame.Camera,
            _settings.FieldOfViewDegrees,
            frame.Light.PositionMoonMe,
            _model.Grid.PixelsPerDegree,
            _identity.Version,
            _identity.CommandLine);
        PixelGrid grid = new(frame.Camera.Width, frame.Camera.Height, _settings.GridHorizontal, _settings.GridVertical);
        PixelSampler pixels = new(frame.Camera, grid, ReferenceSphere.Lola, frame.Light.PositionMoonMe);
        using AtomicFileSet files = new();
        _times.Measure(Phase.Output, () => files.WriteText($"{stem}.pov", writeScene));
        _times.Measure(Phase.Xml, () => files.Write($"{stem}.xml", stream => MetadataXmlWriter.Write(stream, metadata, pixels, cancellation)));
        _times.Measure(Phase.Output, () =>
        {
            if (_settings.Annotate)
            {
                files.Write(
                    $"{stem}.annotated.png", stream => AnnotationRenderer.Write(picture, stream, metadata, pixels, cancellation));
                picture.Position = 0;
            }

            files.Write($"{stem}.png", stream => PngFile.CopyPicture(picture, stream, "POV-Ray's picture"));
            cancellation.ThrowIfCancellationRequested();
            files.Commit();
        });
        return _settings.Annotate
            ? [$"{stem}.png", $"{stem}.annotated.png", $"{stem}.pov", $"{stem}.xml"]
            : [$"{stem}.png", $"{stem}.pov", $"{stem}.xml"];
    }
}
