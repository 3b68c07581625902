using Msisf.Adapters.IO;
using Msisf.Adapters.Navigation;
using Msisf.App.Preparation;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Navigation;
using Msisf.Core.Render;

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
    public static IGroundTruth Mark(IGroundTruth frame, NavigationTruth? navigation, LayerSet layers) =>
        navigation?.Craters is { } craters && layers.Layers.Any(layer => layer.NeedsCraters)
            ? new MarkedFrame(frame, CraterPixels.NumbersOf(craters, frame, threads: 1))
            : frame;

    /// <summary>Writes the files of a frame.</summary>
    /// <param name="files">Receives them.</param>
    /// <param name="stem">Path of the frame's files, without extension.</param>
    /// <param name="metadata">The frame's, with the truth.</param>
    /// <returns>The paths.</returns>
    public static IReadOnlyList<string> Write(AtomicFileSet files, string stem, int step, FrameMetadata metadata)
    {
        List<string> paths = [];
        double referenceRadius = metadata.Globe.ReferenceRadius;
        if (metadata.Navigation?.Craters is { } craters)
        {
            files.WriteText($"{stem}.craters.csv", writer => CraterCsvWriter.Write(writer, craters, referenceRadius));
            files.Write($"{stem}.craters.json", stream => CocoWriter.Write(
                stream, craters, metadata.Camera, (step, $"{Path.GetFileName(stem)}.png"), referenceRadius));
            paths.AddRange([$"{stem}.craters.csv", $"{stem}.craters.json"]);
        }

        if (metadata.Navigation?.Landmarks is { } landmarks)
        {
            files.WriteText($"{stem}.landmarks.csv", writer => LandmarkCsvWriter.Write(writer, landmarks, referenceRadius));
            paths.Add($"{stem}.landmarks.csv");
        }

        return paths;
    }
}
