using Msisf.Adapters.CameraExport;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>
/// Writes the files of a frame for all renderers. They appear when all are complete and recorded in the manifest, the image last.
/// Thread-safe.
/// </summary>
internal sealed class FrameFiles
{
    private readonly RenderSettings _settings;
    private readonly FrameDescription _description;
    private readonly InputComparison _comparison;
    private readonly FrameLedger _ledger;
    private readonly RunTimes _times;
    private readonly ILog _log;
    private readonly IEphemeris? _ephemeris;
    private readonly FrameNavigation? _navigation;
    private readonly FlowOutputs? _flows;
    private readonly MapOutputs? _maps;

    public FrameFiles(
        RenderSettings settings, FrameDescription description, InputComparison comparison, FrameLedger ledger, RunTimes times, ILog log,
        NavigationInputs? navigation = null, IEphemeris? ephemeris = null, MapOutputs? maps = null)
    {
        _settings = settings;
        _description = description;
        _comparison = comparison;
        _ledger = ledger;
        _times = times;
        _log = log;
        _ephemeris = ephemeris;
        _maps = maps;
        _navigation = navigation is null ? null : new FrameNavigation(navigation);
        _flows = settings.Native.Navigation is { } wanted ? new FlowOutputs(wanted) : null;
    }

    /// <summary>A file for an image that is written as it is drawn; it goes when it is closed.</summary>
    public FileStream OpenTemporary() => new(
        Path.Combine(_ledger.Staging, Path.GetRandomFileName()), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None, 1 << 16,
        FileOptions.DeleteOnClose);

    /// <summary>Writes the files.</summary>
    /// <param name="rendered">The result of the renderer.</param>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>The paths of the files, in the order in which they are shown to the user.</returns>
    public IReadOnlyList<string> Write(Frame frame, RenderedFrame rendered, CancellationToken cancellation)
    {
        string stem = Path.Combine(_settings.OutputFolder, frame.Name);
        FrameMetadata metadata = _description.Describe(frame, rendered, _ledger.Plan.ArgumentsOf(frame.Step, frame.CameraIndex)) with
        {
            Navigation = _times.Measure(Phase.Navigation, () => _navigation?.Of(rendered)),
        };
        PixelSampler pixels = _description.Sampler(frame, rendered);
        _comparison.Compare($"{stem}.xml", metadata.Inputs);
        string? annotated = _settings.Annotate ? $"{stem}.annotated.png" : null;
        List<string> paths = annotated is null ? [$"{stem}.png"] : [$"{stem}.png", annotated];
        using AtomicFileSet files = new(_ledger.Staging);
        if (rendered.WriteScene is Action<TextWriter> writeScene)
        {
            _times.Measure(Phase.Output, () => files.WriteText($"{stem}.pov", writeScene));
            paths.Add($"{stem}.pov");
        }

        _times.Measure(
            Phase.Xml,
            () => files.Write($"{stem}.xml", stream => MetadataXmlWriter.Write(stream, metadata, pixels, cancellation: cancellation)));
        paths.Add($"{stem}.xml");
        if (_settings.Native.Detector is { WritesFits: true } detector)
        {
            DetectorSettings exposed = detector.Settings.Exposed(frame.ExposureFactor);
            LayerProvenance provenance = _description.Provenance(metadata, rendered);
            _times.Measure(Phase.Output, () => files.Write(
                $"{stem}.dn.fits", stream => DetectorFitsWriter.Write(stream, rendered.Numbers!, exposed, metadata, provenance)));
            paths.Add($"{stem}.dn.fits");
        }

        if (_settings.CameraFormats.Count > 0)
        {
            ExportedFrame exported = files.Read(
                $"{stem}.xml", stream => CameraOfMetaFile.Read(stream, $"{stem}.xml", frame, metadata, _settings)) with
            {
                Ephemeris = _ephemeris,
                Image = _settings.CameraFormats.Any(format => format.HasPixels)
                    ? ExportedImage.Of(rendered.Truth!, rendered.Detected)
                    : null,
            };
            paths.AddRange(_times.Measure(Phase.Output, () => CameraFormat.Write(
                _settings.CameraFormats, files, stem, exported, _log.Note, _log.Warning)));
        }

        paths.AddRange(_times.Measure(Phase.Navigation, () => FrameNavigation.Write(files, stem, frame.Step, metadata)));
        if (_flows is not null)
        {
            paths.AddRange(_times.Measure(Phase.Navigation, () => _flows.Write(
                files, stem, frame, rendered, metadata, _description.Provenance(metadata, rendered), cancellation)));
        }

        if (_maps is not null)
        {
            paths.AddRange(_times.Measure(Phase.Layers, () => _maps.Write(
                files, stem, frame, rendered, metadata, _description.Provenance(metadata, rendered), cancellation)));
        }

        if (_settings.Native.Layers is LayerSet layers)
        {
            paths.AddRange(_times.Measure(Phase.Layers, () => WriteLayers(files, stem, metadata, rendered, layers, cancellation)));
        }

        _times.Measure(Phase.Output, () =>
        {
            if (annotated is not null)
            {
                files.Write(annotated, stream => AnnotationRenderer.Write(rendered.Image, stream, metadata, pixels, cancellation));
                rendered.Image.Position = 0;
            }

            files.Write($"{stem}.png", stream => PngFile.CopyImage(rendered.Image, stream, rendered.ImageName));
            cancellation.ThrowIfCancellationRequested();
            _ledger.Made(frame, files, paths);
            files.Commit();
        });
        return paths;
    }

    private IReadOnlyList<string> WriteLayers(
        AtomicFileSet files, string stem, FrameMetadata metadata, RenderedFrame rendered, LayerSet layers, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(rendered.Truth);
        IGroundTruth truth = FrameNavigation.Mark(rendered.Truth, metadata.Navigation, layers);
        LayerProvenance provenance = _description.Provenance(metadata, rendered);
        LayerPrecision precision = _settings.Native.LayersPrecision;
        if (_settings.Native.LayersFormat == LayersFormat.Npy)
        {
            return NpyLayerWriter.Write(files, stem, metadata, provenance, truth, layers, precision, cancellation);
        }

        files.Write($"{stem}.fits", stream => FitsLayerWriter.Write(
            stream, metadata, provenance, truth, layers, precision, _settings.Native.LayersCompression, cancellation));
        return [$"{stem}.fits"];
    }
}
