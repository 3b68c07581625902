using Msisf.Adapters.CameraExport;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Navigation;
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
internal sealed class FrameFiles(
    RenderSettings settings, FrameDescription description, InputComparison comparison, FrameLedger ledger, RunTimes times, ILog log,
    NavigationInputs? navigation = null, IEphemeris? ephemeris = null, MapOutputs? maps = null, CraterNote? craters = null)
{
    private readonly FrameNavigation? _navigation = navigation is null ? null : new FrameNavigation(navigation);
    private readonly FlowOutputs? _flows = settings.Native.Navigation is { } wanted ? new FlowOutputs(wanted) : null;

    private readonly SensitivityOutputs? _sensitivities =
        settings.Native.Navigation is null ? null : new SensitivityOutputs(settings.Native);

    /// <summary>A file for an image that is written as it is drawn; it goes when it is closed.</summary>
    public FileStream OpenTemporary() => new(
        Path.Combine(ledger.Staging, Path.GetRandomFileName()), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None, 1 << 16,
        FileOptions.DeleteOnClose);

    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>The paths of the files, in the order in which they are shown to the user.</returns>
    public IReadOnlyList<string> Write(Frame frame, RenderedFrame rendered, CancellationToken cancellation)
    {
        string stem = Path.Combine(settings.OutputFolder, frame.Name);
        FrameMetadata metadata = description.Describe(frame, rendered, ledger.Plan.ArgumentsOf(frame.Step, frame.CameraIndex)) with
        {
            Navigation = times.Measure(Phase.Navigation, () => _navigation?.Of(rendered)),
            Stars = rendered.Sky?.Stars,
            Bodies = rendered.Sky?.Bodies,
        };
        if (metadata.Navigation?.Craters is { } listed)
        {
            craters?.Add(listed);
        }

        PixelSampler pixels = description.Sampler(frame, rendered);
        comparison.Compare($"{stem}.xml", metadata.Inputs);
        string? annotated = settings.Annotate ? $"{stem}.annotated.png" : null;
        List<string> paths = annotated is null ? [$"{stem}.png"] : [$"{stem}.png", annotated];
        using AtomicFileSet files = new(ledger.Staging);
        if (rendered.WriteScene is Action<TextWriter> writeScene)
        {
            times.Measure(Phase.Output, () => files.WriteText($"{stem}.pov", writeScene));
            paths.Add($"{stem}.pov");
        }

        times.Measure(
            Phase.Xml,
            () => files.Write($"{stem}.xml", stream => MetadataXmlWriter.Write(stream, metadata, pixels, cancellation: cancellation)));
        paths.Add($"{stem}.xml");
        if (settings.Native.Detector is { WritesFits: true } detector)
        {
            DetectorSettings exposed = detector.Settings.Exposed(frame.ExposureFactor);
            LayerProvenance provenance = description.Provenance(metadata, rendered);
            times.Measure(Phase.Output, () => files.Write(
                $"{stem}.dn.fits", stream => DetectorFitsWriter.Write(stream, rendered.Numbers!, exposed, metadata, provenance)));
            paths.Add($"{stem}.dn.fits");
        }

        if (settings.CameraFormats.Count > 0)
        {
            ExportedFrame exported = files.Read(
                $"{stem}.xml", stream => CameraOfMetaFile.Read(stream, $"{stem}.xml", frame, metadata, settings)) with
            {
                Ephemeris = ephemeris,
                Image = settings.CameraFormats.Any(format => format.HasPixels)
                    ? ExportedImage.Of(rendered.Truth!, rendered.Detected)
                    : null,
            };
            paths.AddRange(times.Measure(Phase.Output, () => CameraFormat.Write(
                settings.CameraFormats, files, stem, exported, log.Note, log.Warning)));
        }

        paths.AddRange(times.Measure(Phase.Navigation, () => FrameNavigation.Write(files, stem, frame.Step, metadata)));
        if (rendered.Sky?.Stars is { } stars)
        {
            times.Measure(Phase.Sky, () => files.WriteText($"{stem}.stars.csv", writer => SkyCsvWriter.Write(writer, stars)));
            paths.Add($"{stem}.stars.csv");
        }

        if (rendered.Sky?.Bodies is { } bodies)
        {
            times.Measure(Phase.Sky, () => files.WriteText($"{stem}.bodies.csv", writer => SkyCsvWriter.Write(writer, bodies)));
            paths.Add($"{stem}.bodies.csv");
        }

        if (_flows is not null)
        {
            paths.AddRange(times.Measure(Phase.Navigation, () => _flows.Write(
                files, stem, frame, rendered, metadata, description.Provenance(metadata, rendered), cancellation)));
        }

        if (_sensitivities is not null)
        {
            paths.AddRange(times.Measure(Phase.Navigation, () => _sensitivities.Write(
                files, stem, rendered, metadata, description.Provenance(metadata, rendered), cancellation)));
        }

        if (maps is not null)
        {
            paths.AddRange(times.Measure(Phase.Layers, () => maps.Write(
                files, stem, frame, rendered, metadata, description.Provenance(metadata, rendered), cancellation)));
        }

        if (settings.Native.Layers is LayerSet layers)
        {
            paths.AddRange(times.Measure(Phase.Layers, () => WriteLayers(files, stem, metadata, rendered, layers, cancellation)));
        }

        times.Measure(Phase.Output, () =>
        {
            if (annotated is not null)
            {
                files.Write(annotated, stream => AnnotationRenderer.Write(rendered.Image, stream, metadata, pixels, cancellation));
                rendered.Image.Position = 0;
            }

            files.Write($"{stem}.png", stream => PngFile.CopyImage(rendered.Image, stream, rendered.ImageName));
            cancellation.ThrowIfCancellationRequested();
            ledger.Made(frame, files, paths);
            files.Commit();
        });
        return paths;
    }

    private IReadOnlyList<string> WriteLayers(
        AtomicFileSet files, string stem, FrameMetadata metadata, RenderedFrame rendered, LayerSet layers, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(rendered.Truth);
        IGroundTruth truth = FrameNavigation.Mark(rendered.Truth, metadata.Navigation, rendered.Sky, layers);
        LayerProvenance provenance = description.Provenance(metadata, rendered);
        LayerPrecision precision = settings.Native.LayersPrecision;
        if (settings.Native.LayersFormat == LayersFormat.Npy)
        {
            return NpyLayerWriter.Write(files, stem, metadata, provenance, truth, layers, precision, cancellation);
        }

        files.Write($"{stem}.fits", stream => FitsLayerWriter.Write(
            stream, metadata, provenance, truth, layers, precision, settings.Native.LayersCompression, cancellation));
        return [$"{stem}.fits"];
    }
}

/// <summary>The camera of a frame that was drawn just now, for other programs.</summary>
internal static class CameraOfMetaFile
{
    /// <summary>Reads it from the meta file, so that it is the same afterwards; a detector's shutter is not in there.</summary>
    /// <param name="metadata">What the meta file was written from.</param>
    public static ExportedFrame Read(Stream stream, string name, Frame frame, FrameMetadata metadata, RenderSettings settings)
    {
        ExportedFrame exported = MetaFileFrame.Read(stream, name, metadata.SimulationTime.Scale, () => RowStates.Of(metadata));
        return settings.Shutter is { IsRolling: true } shutter && frame is { Scan: null, Motion: { IsRest: false } motion }
            ? exported with
            {
                Scan = ExportedScan.OfShutter(exported.Camera, motion, shutter.LineTime, metadata.HeightOverTerrain),
            }
            : exported;
    }
}
