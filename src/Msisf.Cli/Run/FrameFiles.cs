using Msisf.Adapters.IO;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.Cli.Options;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.Cli.Run;

/// <summary>Writes a frame's files for any renderer. They appear when all are complete, the picture last. Safe for several threads.</summary>
internal sealed class FrameFiles
{
    private readonly RenderSettings _settings;
    private readonly int _pixelsPerDegree;
    private readonly ProgramIdentity _identity;
    private readonly RunTimes _times;

    public FrameFiles(RenderSettings settings, int pixelsPerDegree, ProgramIdentity identity, RunTimes times)
    {
        _settings = settings;
        _pixelsPerDegree = pixelsPerDegree;
        _identity = identity;
        _times = times;
    }

    /// <summary>Writes the files.</summary>
    /// <param name="frame">Which frame.</param>
    /// <param name="rendered">What became of it.</param>
    /// <param name="cancellation">Leaves no file.</param>
    /// <returns>Their paths, in the order in which they are named to the user.</returns>
    public IReadOnlyList<string> Write(Frame frame, RenderedFrame rendered, CancellationToken cancellation)
    {
        string stem = Path.Combine(_settings.OutputFolder, frame.Name);
        FrameMetadata metadata = Describe(frame, rendered.Renderer);
        PixelSampler pixels = Sampler(frame, rendered.Truth);
        string? annotated = _settings.Annotate ? $"{stem}.annotated.png" : null;
        List<string> paths = annotated is null ? [$"{stem}.png"] : [$"{stem}.png", annotated];
        using AtomicFileSet files = new();
        if (rendered.WriteScene is Action<TextWriter> writeScene)
        {
            _times.Measure(Phase.Output, () => files.WriteText($"{stem}.pov", writeScene));
            paths.Add($"{stem}.pov");
        }

        _times.Measure(Phase.Xml, () => files.Write($"{stem}.xml", stream => MetadataXmlWriter.Write(stream, metadata, pixels, cancellation)));
        paths.Add($"{stem}.xml");
        _times.Measure(Phase.Output, () =>
        {
            if (annotated is not null)
            {
                files.Write(annotated, stream => AnnotationRenderer.Write(rendered.Picture, stream, metadata, pixels, cancellation));
                rendered.Picture.Position = 0;
            }

            files.Write($"{stem}.png", stream => PngFile.CopyPicture(rendered.Picture, stream, rendered.PictureName));
            cancellation.ThrowIfCancellationRequested();
            files.Commit();
        });
        return paths;
    }

    private FrameMetadata Describe(Frame frame, RendererKind renderer) => new(
        frame.Time,
        frame.Camera,
        _settings.FieldOfViewDegrees,
        frame.Light.PositionMoonMe,
        _pixelsPerDegree,
        _identity.Version,
        _identity.CommandLine,
        renderer);

    private PixelSampler Sampler(Frame frame, IFrameTruth? truth)
    {
        PixelGrid grid = new(frame.Camera.Width, frame.Camera.Height, _settings.GridHorizontal, _settings.GridVertical);
        if (_settings.Surface == PixelSurface.Sphere)
        {
            return new PixelSampler(frame.Camera, grid, ReferenceSphere.Lola, frame.Light.PositionMoonMe);
        }

        ArgumentNullException.ThrowIfNull(truth);
        return new PixelSampler(grid, truth, _pixelsPerDegree);
    }
}
