using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Navigation;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Sensitivity;

namespace Msisf.App.Rendering;

/// <summary>Finds and writes the derivatives of frames, and what their images tell. Thread-safe.</summary>
/// <param name="settings">Settings of the native renderer, with what is wanted.</param>
internal sealed class SensitivityOutputs(NativeSettings settings)
{
    /// <param name="stem">Path of the frame's files, without extension.</param>
    public IReadOnlyList<string> Write(
        AtomicFileSet files, string stem, RenderedFrame rendered, FrameMetadata metadata, LayerProvenance provenance,
        CancellationToken cancellation)
    {
        NavigationSettings wanted = settings.Navigation!;
        if (wanted.Sensitivity is null && wanted.Information is null)
        {
            return [];
        }

        ImageSensitivity found = rendered.FindSensitivity!(cancellation);
        List<string> paths = [];
        if (wanted.Sensitivity is { } parameters)
        {
            LayerSet layers = SensitivityLayers.Of(found.Field, parameters, found.Signal);
            if (settings.LayersFormat == LayersFormat.Npy)
            {
                paths.AddRange(NpyLayerWriter.Write(
                    files, $"{stem}.sensitivity", metadata, provenance, rendered.Truth!, layers, settings.LayersPrecision, cancellation));
            }
            else
            {
                files.Write($"{stem}.sensitivity.fits", stream => FitsLayerWriter.Write(
                    stream, metadata, provenance, rendered.Truth!, layers, settings.LayersPrecision, settings.LayersCompression,
                    cancellation));
                paths.Add($"{stem}.sensitivity.fits");
            }
        }

        if (wanted.Information is { } unknowns)
        {
            FisherInformation information = found.InformationOf!(unknowns);
            files.WriteText($"{stem}.information.csv", writer => InformationCsvWriter.Write(writer, information));
            paths.Add($"{stem}.information.csv");
        }

        return paths;
    }
}
