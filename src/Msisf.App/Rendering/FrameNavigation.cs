using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Navigation;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Navigation;
using Msisf.Core.Render;
using Msisf.Core.Sky;

namespace Msisf.App.Rendering;

/// <summary>Finds and writes the truth for navigation of frames. Thread-safe.</summary>
/// <param name="inputs">What it is made from.</param>
internal sealed class FrameNavigation(NavigationInputs inputs)
{
    public NavigationTruth Of(RenderedFrame rendered)
    {
        ArgumentNullException.ThrowIfNull(rendered.Truth);
        ArgumentNullException.ThrowIfNull(rendered.Terrain);
        IGroundTruth frame = rendered.Truth;
        return new NavigationTruth
        {
            Craters = inputs.Craters is { } finder
                ? CraterPixels.WithParts(finder.Find(frame.Camera, frame.Light, rendered.Terrain), frame)
                : null,
            Landmarks = inputs.Landmarks?.Find(frame.Camera, frame.Light, rendered.Terrain),
        };
    }

    /// <summary>The frame's truth with what layers need of this one.</summary>
    public static IGroundTruth Mark(IGroundTruth frame, NavigationTruth? navigation, SkyOfFrame? sky, LayerSet layers)
    {
        int[] craters = navigation?.Craters is { } found && layers.Layers.Any(layer => layer.NeedsCraters)
            ? CraterPixels.NumbersOf(found, frame, threads: 1)
            : [];
        int[] objects = sky is not null && layers.Layers.Any(layer => layer.NeedsSky)
            ? SkyPixels.ObjectsOf(frame, sky.Axes, sky.Stars, sky.Bodies, threads: 1)
            : [];
        return craters.Length + objects.Length == 0 ? frame : new MarkedFrame(frame, craters, objects);
    }

    /// <param name="stem">Path of the frame's files, without extension.</param>
    public static IReadOnlyList<string> Write(AtomicFileSet files, string stem, int step, FrameMetadata metadata)
    {
        List<string> paths = [];
        double referenceRadius = metadata.Globe.ReferenceRadius;
        if (metadata.Navigation?.Craters is { } craters)
        {
            files.WriteText($"{stem}.craters.csv", writer => NavigationCsvWriter.Write(writer, craters, referenceRadius));
            files.Write($"{stem}.craters.json", stream => CocoWriter.Write(
                stream, craters, metadata.Camera,
                new CocoSource($"Craters of {Path.GetFileName(stem)}", metadata.Version, [CocoSource.NoLicence]),
                new CocoImage(step, $"{Path.GetFileName(stem)}.png", metadata.SimulationTime), referenceRadius));
            paths.AddRange([$"{stem}.craters.csv", $"{stem}.craters.json"]);
        }

        if (metadata.Navigation?.Landmarks is { } landmarks)
        {
            files.WriteText($"{stem}.landmarks.csv", writer => NavigationCsvWriter.Write(writer, landmarks, referenceRadius));
            paths.Add($"{stem}.landmarks.csv");
        }

        return paths;
    }
}

/// <summary>Finds and writes the flow of a frame to another one, and the disparity to a camera beside it. Thread-safe.</summary>
internal sealed class FlowOutputs(NavigationSettings settings)
{
    /// <param name="stem">Path of the frame's files, without extension.</param>
    public IReadOnlyList<string> Write(
        AtomicFileSet files, string stem, Frame frame, RenderedFrame rendered, FrameMetadata metadata, LayerProvenance provenance,
        CancellationToken cancellation)
    {
        if (frame.Flow is null && settings.Stereo is null)
        {
            return [];
        }

        ArgumentNullException.ThrowIfNull(rendered.Redraw);
        ArgumentNullException.ThrowIfNull(rendered.Truth);
        FrameCamera camera = (FrameCamera)frame.Camera; // FlowStates refuses others
        FlowFinder finder = new(rendered.Truth, rendered.Redraw);
        List<string> paths = [];
        if (frame.Flow is { } target)
        {
            FlowField flow = finder.Find(target, rendered.Threads, cancellation);
            WriteLayers($"{stem}.flow", FlowLayers.OfFlow(flow));
            Put(FlowFormats.Middlebury, ".flow.flo", stream => FlowFiles.WriteMiddlebury(stream, flow));
            Put(FlowFormats.Kitti, ".flow.png", stream => FlowFiles.WriteKitti(stream, flow));
        }

        if (settings.Stereo is { } baseline)
        {
            CameraState right = camera.State with { PositionBodyFixed = camera.PositionBodyFixed + (baseline * camera.UnitRight) };
            FlowField flow = finder.Find(new FlowTarget(camera.Model.At(right), frame.Light), rendered.Threads, cancellation);
            WriteLayers($"{stem}.stereo", FlowLayers.OfStereo(flow));
            Put(FlowFormats.Kitti, ".disparity.png", stream => FlowFiles.WriteKittiDisparity(stream, flow));
        }

        return paths;

        void Put(FlowFormats format, string ending, Action<Stream> write)
        {
            if (settings.FlowFormats.HasFlag(format))
            {
                files.Write(stem + ending, write);
                paths.Add(stem + ending);
            }
        }

        void WriteLayers(string name, LayerSet layers)
        {
            if (settings.FlowFormats.HasFlag(FlowFormats.Fits))
            {
                files.Write($"{name}.fits", stream => FitsLayerWriter.Write(
                    stream, metadata, provenance, rendered.Truth, layers, cancellation: cancellation));
                paths.Add($"{name}.fits");
            }

            if (settings.FlowFormats.HasFlag(FlowFormats.Npy))
            {
                NpyLayerWriter.Write(
                    (file, _, write) =>
                    {
                        string path = file == "layers.json" ? $"{name}.json" : $"{stem}.{file}";
                        files.Write(path, write);
                        paths.Add(path);
                    },
                    metadata, provenance, rendered.Truth, layers, LayerPrecision.Real64, hasHeads: true, cancellation);
            }
        }
    }
}
