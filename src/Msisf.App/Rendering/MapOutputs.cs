using Msisf.Adapters.CameraExport;
using Msisf.Adapters.IO;
using Msisf.Adapters.Maps;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Maps;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>Puts frames and their layers on a map. Thread-safe.</summary>
/// <param name="native">Which layers, and how precise.</param>
/// <param name="libraryPath">MSISF_GDAL, or null.</param>
/// <param name="log">Is told of frames without ground.</param>
internal sealed class MapOutputs(MapSettings settings, NativeSettings native, string? libraryPath, ILog log)
{
    /// <param name="stem">Path of the frame's files, without extension.</param>
    /// <returns>The paths; none if the frame shows no ground.</returns>
    public IReadOnlyList<string> Write(
        AtomicFileSet files, string stem, Frame frame, RenderedFrame rendered, FrameMetadata metadata, LayerProvenance provenance,
        CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(rendered.Truth);
        ArgumentNullException.ThrowIfNull(rendered.Terrain);
        IGroundTruth truth = rendered.Truth;
        ImageMap? map = new ImageMapper(truth, rendered.Terrain)
            .Find(settings.Kind, settings.Cell, rendered.Threads, cancellation);
        if (map is null)
        {
            log.Note($"{frame.Name} shows no ground, so there is no map of it.");
            return [];
        }

        ImageMapFiles writer = new(map, metadata, libraryPath);
        List<string> paths = [writer.WriteImage(files, stem, ExportedImage.Of(truth, rendered.Detected))];
        if (native.Layers is { } layers)
        {
            paths.AddRange(writer.WriteLayers(
                files, stem, FrameNavigation.Mark(truth, metadata.Navigation, rendered.Sky, layers), provenance, layers,
                native.LayersPrecision, cancellation));
        }

        return paths;
    }
}
